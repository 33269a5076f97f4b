// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <cstdlib>
#include <optional>
#include <string>

/// Sets an environment variable of this process.
inline void setEnvironment(const char* name, const char* value) {
#ifdef _WIN32
    _wputenv_s(osgTreeWind::toPath(name).c_str(), osgTreeWind::toPath(value).c_str());
#else
    setenv(name, value, 1);
#endif
}

/// Removes an environment variable of this process.
inline void unsetEnvironment(const char* name) {
#ifdef _WIN32
    _putenv_s(name, "");
#else
    unsetenv(name);
#endif
}

/// Sets an environment variable during its lifetime.
class EnvironmentVariable {
public:
    EnvironmentVariable(const char* name, const char* value)
        : _name(name), _former(osgTreeWind::environmentVariable(name)) {
        setEnvironment(name, value);
    }
    ~EnvironmentVariable() {
        if (_former)
            setEnvironment(_name, _former->c_str());
        else
            unsetEnvironment(_name);
    }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

private:
    const char* _name;
    std::optional<std::string> _former;
};
