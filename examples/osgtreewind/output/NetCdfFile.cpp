// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/NetCdfFile.h>

#include <osgTreeWind/places/GridMapping.h>
#include <osgTreeWind/system/Program.h>

#include <cerrno>
#include <cstring>

using namespace osgTreeWind;

namespace {

/// Keeps HDF5 from closing files when the process ends: it crashes if a file could not be written.
void skipClosingAtExit() {
    using Function = int (*)();
    static const auto skip = reinterpret_cast<Function>(findFunction("H5dont_atexit"));
    static const int result = skip ? skip() : 0;
    static_cast<void>(result);
}

} // namespace

/// Remembers the first error. HDF5 errors have their reason in errno.
void NetCdfFile::check(int status) {
    if (status != NC_NOERR && _problem.empty())
        _problem = status == NC_EHDFERR && errno != 0 ? std::strerror(errno) : nc_strerror(status);
}

/// Calls a function of the library, unless there was an error.
template <typename Function, typename... Arguments>
void NetCdfFile::call(Function function, Arguments... arguments) {
    errno = 0;
    if (_problem.empty())
        check(function(_file, arguments...));
}

NetCdfFile::NetCdfFile(const std::string& path, int format) {
    skipClosingAtExit();
    check(nc_create(path.c_str(), NC_CLOBBER | format, &_file));
    _open = _problem.empty();
    int before = 0;
    call(nc_set_fill, NC_NOFILL, &before);
}

int NetCdfFile::defineDimension(const char* name, std::size_t size) {
    int id = 0;
    call(nc_def_dim, name, size, &id);
    return id;
}

int NetCdfFile::defineVariable(const char* name, int type, const std::vector<int>& dimensions) {
    int id = 0;
    call(nc_def_var, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &id);
    return id;
}

void NetCdfFile::compress(int variable, const std::vector<std::size_t>& chunk) {
    call(nc_def_var_chunking, variable, NC_CHUNKED, chunk.data());
    call(nc_def_var_deflate, variable, 1, 1, 1); // shuffled, at the fastest level
}

int NetCdfFile::defineMap(const Crs& map) {
    const int crs = defineVariable("crs", NC_DOUBLE, {});
    const Result<GridMapping> described = gridMappingOf(map);
    const GridMapping mapping = described ? described.value() : GridMapping();
    setAttribute(crs, "long_name", "coordinate reference system");
    if (!mapping.name.empty())
        setAttribute(crs, "grid_mapping_name", mapping.name);
    for (const auto& [name, numbers] : mapping.numbers)
        setAttribute(crs, name.c_str(), numbers);
    setAttribute(crs, "crs_wkt", mapping.wkt);
    setAttribute(crs, "units", "m");
    if (const std::string text = map.text(); text.rfind("EPSG:", 0) == 0)
        setAttribute(crs, "epsg_code", text);
    return crs;
}

void NetCdfFile::setAttribute(int variable, const char* name, const std::string& text) {
    call(nc_put_att_text, variable, name, text.size(), text.c_str());
}

void NetCdfFile::setAttribute(int variable, const char* name, const std::vector<double>& numbers) {
    call(nc_put_att_double, variable, name, NC_DOUBLE, numbers.size(), numbers.data());
}

void NetCdfFile::setAttribute(int variable, const char* name, float number) {
    call(nc_put_att_float, variable, name, NC_FLOAT, std::size_t(1), &number);
}

void NetCdfFile::describe(int variable, const std::string& words, const std::string& units) {
    setAttribute(variable, "long_name", words);
    setAttribute(variable, "units", units);
}

void NetCdfFile::describeFile(const std::string& title) {
    setAttribute(global, "Conventions", "CF-1.7");
    setAttribute(global, "title", title);
    setAttribute(global, "source", "osgtreewind " OSGTREEWIND_VERSION);
}

void NetCdfFile::endDefinitions() {
    call(nc_enddef);
}

void NetCdfFile::write(int variable, const std::vector<double>& numbers) {
    call(nc_put_var_double, variable, numbers.data());
}

void NetCdfFile::write(int variable, const std::vector<int>& numbers) {
    call(nc_put_var_int, variable, numbers.data());
}

void NetCdfFile::write(int variable, const std::vector<std::string>& texts) {
    std::vector<const char*> pointers;
    for (const std::string& text : texts)
        pointers.push_back(text.c_str());
    call(nc_put_var_string, variable, pointers.data());
}

void NetCdfFile::write(int variable, const std::vector<std::size_t>& start,
                       const std::vector<std::size_t>& count, const float* numbers) {
    call(nc_put_vara_float, variable, start.data(), count.data(), numbers);
}

void NetCdfFile::write(int variable, const std::vector<std::size_t>& start,
                       const std::vector<std::size_t>& count, const double* numbers) {
    call(nc_put_vara_double, variable, start.data(), count.data(), numbers);
}

bool NetCdfFile::close() {
    if (_open)
        check(nc_close(_file));
    _open = false;
    return _problem.empty();
}
