// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/AtomicTable.h>

#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/system/File.h>

AtomicTable::AtomicTable(const std::string& path) {
    if (path == "-")
        return;
    _whole.emplace(path);
    _file = osgTreeWind::openFile(_whole->writePath(), "wb").release();
    if (!_file)
        throwWriteError(*_whole);
}

AtomicTable::~AtomicTable() {
    if (_whole && _file)
        std::fclose(_file);
}

void AtomicTable::finish() {
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
