// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/StandProfile.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/wind/CanopyProfile.h>

#include <algorithm>

namespace osgTreeWind {

Result<std::vector<float>> readLeafShares(const std::string& path, std::size_t layers) {
    Result<std::ifstream> file = openInput(path);
    if (!file)
        return file.problems();
    std::vector<double> shares(layers, 0.0);
    double below = 0.0, sum = 0.0;
    const Diagnostics problems =
        readCsvWithColumns(file.value(), path, {"z_over_h", "leaf_area"}, [&](CsvCells& row) {
            const double top = row.number(0, within(0.0, 1.0)), density = row.number(1, within(0.0, 1e6));
            if (!row.problem() && top < below)
                row.failExpected(0, "a height above that of the row before");
            for (std::size_t i = 0; i < layers; ++i) {
                const double foot = static_cast<double>(i) / static_cast<double>(layers),
                             head = static_cast<double>(i + 1) / static_cast<double>(layers),
                             leaves = density * std::max(std::min(top, head) - std::max(below, foot), 0.0);
                shares[i] += leaves;
                sum += leaves;
            }
            below = top;
        });
    if (!problems.empty())
        return problems;
    if (!(sum > 0.0))
        return Diagnostics{fileProblem(path, "expected rows with leaf_area above 0")};
    std::vector<float> result;
    for (const double share : shares)
        result.push_back(static_cast<float>(share / sum));
    return result;
}

void writeStandProfile(const StandFlow& flow, double height, std::FILE* out) {
    std::fputs("z_over_h,z_m,u_over_uh,stress_over_ustar2,sigma_u_over_ustar,sigma_v_over_ustar,sigma_w_over_"
               "ustar\n",
               out);
    const std::size_t top = flow.mean.size() - 1;
    for (std::size_t i = 0; i <= top; ++i) {
        const double z = static_cast<double>(i) / static_cast<double>(top);
        const float turbulence = flow.turbulence[i];
        std::fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", z, z * height,
                     static_cast<double>(flow.mean[i]), static_cast<double>(flow.stress[i]),
                     static_cast<double>(turbulence * spreadAtTop.along),
                     static_cast<double>(turbulence * spreadAtTop.across),
                     static_cast<double>(turbulence * spreadAtTop.up));
    }
}

} // namespace osgTreeWind
