// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFile.h>

#include <osgTreeWind/base/Number.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace {

using namespace osgTreeWind;

std::string triple(const glm::dvec3& v) {
    return numberText(v.x) + ' ' + numberText(v.y) + ' ' + numberText(v.z);
}

const char* byteOrder() {
    const std::uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    return first ? "LittleEndian" : "BigEndian";
}

/// XML followed by the two arrays, each preceded by its length in bytes.
class VtkCanopy : public CanopyFile {
public:
    VtkCanopy(const std::string& path, const CanopyHead& head)
        : _cells(head.grid.cells), _file(path, std::ios::binary) {
        const std::string extent = "0 " + std::to_string(_cells.x) + " 0 " + std::to_string(_cells.y) +
                                   " 0 " + std::to_string(_cells.z);
        const CanopyGrid& grid = head.grid;
        _bytes = sizeof(float) * static_cast<std::uint64_t>(_cells.x) * static_cast<std::uint64_t>(_cells.y) *
                 static_cast<std::uint64_t>(_cells.z);
        _file << R"(<?xml version="1.0"?>
<!-- m2 of leaves and of drag area (CdA) in a m3 of air -->
<VTKFile type="ImageData" version="1.0" byte_order=")"
              << byteOrder() << R"(" header_type="UInt64">
<ImageData WholeExtent=")"
              << extent << R"(" Origin=")" << triple(grid.low) << R"(" Spacing=")" << triple(grid.cell)
              << R"(">
<Piece Extent=")"
              << extent << R"(">
<PointData/>
<CellData Scalars="lad">
<DataArray type="Float32" Name="lad" format="appended" offset="0"/>
<DataArray type="Float32" Name="cda" format="appended" offset=")"
              << sizeof _bytes + _bytes << R"("/>
</CellData>
</Piece>
</ImageData>
<AppendedData encoding="raw">
_)";
        _leaf = _file.tellp();
        _drag = _leaf + static_cast<std::streamoff>(sizeof _bytes + _bytes);
        for (std::streampos* const array : {&_leaf, &_drag}) {
            _file.seekp(*array);
            _file.write(reinterpret_cast<const char*>(&_bytes), sizeof _bytes);
            *array = _file.tellp();
        }
    }

    bool write(const CanopyRow& row) override {
        put(_leaf, row.row, row.leaf);
        put(_drag, row.row, row.drag);
        return isGood();
    }

    bool close() override {
        _file.seekp(_drag + static_cast<std::streamoff>(_bytes));
        _file << "\n</AppendedData>\n</VTKFile>\n";
        _file.close();
        return isGood();
    }

    std::string problem() const override { return _problem; }

private:
    bool isGood() {
        if (!_file && _problem.empty())
            _problem = std::strerror(errno);
        return static_cast<bool>(_file);
    }

    void put(std::streampos array, int row, const Span<float>& field) {
        const auto width = static_cast<std::streamoff>(_cells.x);
        for (int z = 0; z < _cells.z; ++z) {
            const std::streamoff at = (static_cast<std::streamoff>(z) * _cells.y + row) * width;
            _file.seekp(array + at * static_cast<std::streamoff>(sizeof(float)));
            _file.write(reinterpret_cast<const char*>(field.data + z * width),
                        width * static_cast<std::streamoff>(sizeof(float)));
        }
    }

    glm::ivec3 _cells;
    std::ofstream _file;
    std::string _problem;
    std::uint64_t _bytes = 0;    ///< Size of an array.
    std::streampos _leaf, _drag; ///< Start of the arrays.
};

} // namespace

std::unique_ptr<CanopyFile> createVtkCanopy(const std::string& path, const CanopyHead& head) {
    return std::make_unique<VtkCanopy>(path, head);
}
