// SPDX-License-Identifier: MIT
// Real files of every format, truncated and changed: read as a valid wind or refused with a reason.
#include <tests/FullTests.h>
#include <tests/windfiles/NetCdfReading.h>

#include <tests/TestData.h>
#include <tests/io/TemporaryFolder.h>

#include <cmath>
#include <random>

namespace osgTreeWind {

namespace {

struct RealFile {
    const char* name;
    const char* path;
    const char* partner = ""; ///< The other half of a pair.
};

void PrintTo(const RealFile& file, std::ostream* out) {
    *out << file.path;
}

void expectReasonOrValidWind(const std::string& path, const std::string& what) {
    const Result<WindFile> file = readWindFile(path);
    if (!file) {
        ASSERT_FALSE(file.problems().empty()) << what;
        EXPECT_FALSE(file.problems().front().message.empty()) << what;
        EXPECT_FALSE(file.problems().front().file.empty()) << what;
        return;
    }
    const WindSummary& summary = file.value().summary;
    const glm::vec3 low(summary.low), high(summary.high);
    const double last = summary.times.empty() ? 0.0 : summary.times.back();
    EXPECT_LE(summary.slowest, summary.fastest) << what;
    for (const glm::vec3& place : {low, 0.5f * (low + high), high, glm::vec3(0.0f)})
        for (const double time : {0.0, 0.5 * last, last}) {
            const glm::vec3 wind = asField(file.value().wind)->velocity(place, time);
            // A logarithmic profile with a changed roughness may exceed the limit of measured winds.
            EXPECT_LT(std::abs(wind.x) + std::abs(wind.y) + std::abs(wind.z), 1e6f) << what;
        }
}

class DamagedSharedWind : public testing::TestWithParam<RealFile> {
protected:
    /// Writes the damaged file, with the other file of its pair beside it.
    std::string write(const std::string& bytes) const {
        const std::string name = GetParam().path;
        return _folder.write(name.substr(name.rfind('/') + 1), bytes);
    }
    void writePartner() const {
        const std::string name = GetParam().partner;
        if (!name.empty())
            _folder.write(name.substr(name.rfind('/') + 1), fileBytes(realData(name)));
    }

private:
    const TemporaryFolder _folder;
};

} // namespace

TEST_P(DamagedSharedWind, TruncatedFiles) {
    REQUIRE_REAL_DATA(path, GetParam().path);
    writePartner();
    const std::string whole = fileBytes(path);
    std::mt19937 random(11);
    for (const double part : {0.0, 0.001, 0.1, 0.5, 0.9, 0.999}) {
        const auto length = static_cast<std::size_t>(part * static_cast<double>(whole.size())) + random() % 7;
        expectReasonOrValidWind(write(whole.substr(0, length)), "cut at " + std::to_string(length));
    }
}

/// Half of the changes fall into the first 2000 bytes, where headers are.
TEST_P(DamagedSharedWind, ChangedBytes) {
    REQUIRE_REAL_DATA(path, GetParam().path);
    writePartner();
    const std::string whole = fileBytes(path);
    std::mt19937 random(12);
    for (int round = 0; round < casesToRun(16, 5); ++round) {
        std::string bytes = whole;
        for (unsigned changes = 1u << round % 5; changes > 0; --changes) {
            const std::size_t range = random() % 2 ? std::min<std::size_t>(2000, bytes.size()) : bytes.size();
            bytes[random() % range] =
                static_cast<char>(random() % 2 ? random() : "0123456789-.eE <>\"\n"[random() % 19]);
        }
        expectReasonOrValidWind(write(bytes), "round " + std::to_string(round));
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, DamagedSharedWind,
    testing::Values(RealFile{"Ndfd", "wind/ndfd_20170603T1800.nc"}, RealFile{"Wrf", "wind/ci_test_file.nc"},
                    RealFile{"Vtk", "wind/array.mean0D_UAvg.vtk"},
                    RealFile{"TurbSim", "wind/TurbSim_WithTwr.bts"},
                    RealFile{"Toa5", "wind/TOA5_6843.ts_Above_2012_06_07_1245.dat"},
                    RealFile{"QesSensor", "utah_campus/sensor2015.xml"},
                    RealFile{"WindNinjaSpeed", "wind/windninja_pig/198001010100/output/PIG_1000m_vel.asc",
                             "wind/windninja_pig/198001010100/output/PIG_1000m_ang.asc"},
                    RealFile{"WindNinjaDirection", "wind/windninja_pig/198001010100/output/PIG_1000m_ang.asc",
                             "wind/windninja_pig/198001010100/output/PIG_1000m_vel.asc"}),
    [](const auto& info) { return info.param.name; });

} // namespace osgTreeWind
