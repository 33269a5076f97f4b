// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

/// Sets an environment variable during its lifetime.
class EnvironmentVariable {
public:
    EnvironmentVariable(const char* name, const char* value) : _name(name) {
        if (const char* former = std::getenv(name))
            _former = former;
        setenv(name, value, 1);
    }
    ~EnvironmentVariable() {
        if (_former)
            setenv(_name, _former->c_str(), 1);
        else
            unsetenv(_name);
    }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

private:
    const char* _name;
    std::optional<std::string> _former;
};
