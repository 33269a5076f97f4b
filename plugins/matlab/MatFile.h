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
    /// @param fail is told what is wrong, from within libmatio, which would go on for long where a number is
    /// damaged or memory ended: it does not return.
    MatFile(const std::string& path, void (*fail)(const std::string& reason));

    std::vector<matvar_t*> variables() const;
    /// Null for none of this name.
    matvar_t* variable(const std::string& name) const;

private:
    struct Free {
        void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
        void operator()(mat_t* file) const { Mat_Close(file); }
    };

    std::unique_ptr<mat_t, Free> _file;
    std::vector<std::unique_ptr<matvar_t, Free>> _variables;
};

/// How many elements a variable has: the product of its sizes.
std::size_t elements(const matvar_t& variable);
/// Its real numbers, column after column; none where they are no numbers, or not there.
std::vector<double> numbers(const matvar_t& variable);

} // namespace osgTreeWind
