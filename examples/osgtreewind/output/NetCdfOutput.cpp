// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/NetCdfOutput.h>

#include <netcdf.h>

static_assert(NetCdfOutput::wholeFile == NC_GLOBAL);

NetCdfOutput::NetCdfOutput(const std::string& path, double largestArray) {
    // The classic kind with long offsets, which all programs read; it holds 4 GiB an array.
    const int kind = largestArray < 4.0e9 ? NC_64BIT_OFFSET : NC_64BIT_DATA;
    keep(nc_create(path.c_str(), NC_CLOBBER | kind, &_file));
    _open = ok();
    int before = 0;
    if (_open)
        keep(nc_set_fill(_file, NC_NOFILL, &before)); // all of it is written
}

NetCdfOutput::~NetCdfOutput() {
    if (_open)
        nc_close(_file);
}

void NetCdfOutput::keep(int status) {
    if (status != NC_NOERR && ok())
        _problem = nc_strerror(status);
}

int NetCdfOutput::dimension(const char* name, int size) {
    int id = 0;
    if (ok())
        keep(nc_def_dim(_file, name, static_cast<std::size_t>(size), &id));
    return id;
}

int NetCdfOutput::array(const char* name, int type, const std::vector<int>& dimensions) {
    int id = 0;
    if (ok())
        keep(nc_def_var(_file, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &id));
    return id;
}

int NetCdfOutput::field(const char* name, const std::vector<int>& dimensions) {
    return array(name, NC_FLOAT, dimensions);
}

int NetCdfOutput::coordinates(const char* name, const std::vector<int>& dimensions) {
    return array(name, NC_DOUBLE, dimensions);
}

void NetCdfOutput::attribute(int array, const char* name, const std::string& text) {
    if (ok())
        keep(nc_put_att_text(_file, array, name, text.size(), text.c_str()));
}

void NetCdfOutput::attribute(int array, const char* name, const std::vector<double>& numbers) {
    if (ok())
        keep(nc_put_att_double(_file, array, name, NC_DOUBLE, numbers.size(), numbers.data()));
}

void NetCdfOutput::attribute(int array, const char* name, float number) {
    if (ok())
        keep(nc_put_att_float(_file, array, name, NC_FLOAT, 1, &number));
}

void NetCdfOutput::endDefinitions() {
    if (ok())
        keep(nc_enddef(_file));
}

void NetCdfOutput::write(int array, const std::vector<double>& numbers) {
    if (ok())
        keep(nc_put_var_double(_file, array, numbers.data()));
}

void NetCdfOutput::write(int array, const std::vector<std::size_t>& start,
                         const std::vector<std::size_t>& count, const float* numbers) {
    if (ok())
        keep(nc_put_vara_float(_file, array, start.data(), count.data(), numbers));
}

void NetCdfOutput::close() {
    if (_open)
        keep(nc_close(_file));
    _open = false;
}
