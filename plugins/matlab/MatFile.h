// SPDX-License-Identifier: MIT
#pragma once

#include <matio.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// All variables of a .mat file.
class MatFile {
public:
    /// @param fail called with the reason of a failure; it must not return, because libmatio may go on for
    /// long with a damaged number or without memory.
    MatFile(const std::string& path, void (*fail)(const std::string& reason));

    std::vector<matvar_t*> variables() const;
    /// The variable of this name; null if there is none.
    matvar_t* variable(const std::string& name) const;

private:
    struct Free {
        void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
        void operator()(mat_t* file) const { Mat_Close(file); }
    };

    std::unique_ptr<mat_t, Free> _file;
    std::vector<std::unique_ptr<matvar_t, Free>> _variables;
};

/// Number of elements of a variable: the product of its dimensions.
std::size_t elementCount(const matvar_t& variable);
/// Values of a real numeric variable, column by column; empty for any other variable.
std::vector<double> numbers(const matvar_t& variable);

} // namespace osgTreeWind
