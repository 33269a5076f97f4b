// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/WholeTable.h>

#include <examples/osgtreewind/output/CommandError.h>

WholeTable::WholeTable(const std::string& path) {
    if (path == "-")
        return;
    _whole.emplace(path);
    _file = std::fopen(_whole->writePath().c_str(), "w");
    if (!_file)
        throwWriteError(*_whole);
}

WholeTable::~WholeTable() {
    if (_whole && _file)
        std::fclose(_file);
}

void WholeTable::finish() {
    const bool isGood = std::fflush(_file) == 0 && std::ferror(_file) == 0;
    if (!_whole) {
        if (!isGood)
            throw CommandError{Failed, "standard output: cannot be written"};
        return;
    }
    const bool isClosed = std::fclose(_file) == 0;
    _file = nullptr;
    if (!isGood || !isClosed || !_whole->commit())
        throwWriteError(*_whole);
}
