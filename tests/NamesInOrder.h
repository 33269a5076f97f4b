// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Names of the parameters of a parameterized test suite, in their order.
class NamesInOrder {
public:
    NamesInOrder(std::initializer_list<std::string> names) : _names(names) {}

    template <typename T>
    std::string operator()(const testing::TestParamInfo<T>& value) const {
        return _names.at(value.index);
    }

private:
    std::vector<std::string> _names;
};
