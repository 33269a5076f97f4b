// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// A file or folder that is removed with all in it, unless it is finished in time.
class Unfinished {
public:
    /// @param path nothing has to be there yet.
    explicit Unfinished(std::string path);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    const std::string& path() const { return _path; }
    /// It stays.
    void finish();
    /// It stays, under another name, in place of what is there. @return whether it could be moved.
    bool finishAs(const std::string& path);

    /// Removes all unfinished files and folders of a program that is about to end. A thread that then makes
    /// or finishes one blocks for ever.
    static void removeAll();

private:
    std::string _path;
};

} // namespace osgTreeWind
