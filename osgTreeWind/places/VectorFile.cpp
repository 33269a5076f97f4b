// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/VectorFile.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/places/MapProgram.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

using Task = MapQuestion::Task;

struct VectorFile::Reading {
    std::string path;
    MapProgram program;
    FeatureFileHead head{};
    FeatureLayer layer{};
    std::optional<Crs> crs{};
    CrsWay way{};
    std::vector<std::size_t> columns{}; ///< That are asked for,
    std::vector<std::size_t> slots{};   ///< and where each column of the layer is among them.
    FeatureBatch batch{};
    std::size_t index = 0;  ///< One past the feature, in the batch.
    bool isAsked = false;   ///< Whether the next batch is on its way.
    Diagnostics problems{}; ///< Of the program: none can be read any more.

    explicit Reading(const std::string& file) : path(file), program({file}) {}

    void ask();
    bool take();
    void stop();
    const FeatureBatch::Column* column(std::size_t column) const;
};

/// The program reads on while the features before are used.
void VectorFile::Reading::ask() {
    program.send({Task::NextFeatures});
    isAsked = true;
}

/// Takes the batch that was asked for. False where it does not come.
bool VectorFile::Reading::take() {
    auto received = program.get<FeatureBatch>();
    isAsked = false;
    index = 0;
    if (!received) {
        problems = received.problems();
        batch = {};
        return false;
    }
    batch = std::move(received.value());
    return true;
}

/// Null for one that was not asked for.
const FeatureBatch::Column* VectorFile::Reading::column(std::size_t column) const {
    return slots[column] < batch.columns.size() ? &batch.columns[slots[column]] : nullptr;
}

/// Takes what is on its way, so that the program hears the next question.
void VectorFile::Reading::stop() {
    if (isAsked)
        take();
}

VectorFile::VectorFile() = default;
VectorFile::VectorFile(std::unique_ptr<Reading> reading) : _reading(std::move(reading)) {}
VectorFile::VectorFile(VectorFile&&) noexcept = default;
VectorFile& VectorFile::operator=(VectorFile&&) noexcept = default;
VectorFile::~VectorFile() = default;

bool VectorFile::knows(const std::string& path) {
    if (lower(std::filesystem::path(path).extension().string()) == ".csv")
        return false;
    const auto known = MapProgram({path}).ask<bool>({Task::KnowFeatures, {path}});
    return known && known.value();
}

Result<VectorFile> VectorFile::open(const std::string& path) {
    auto reading = std::make_unique<Reading>(path);
    auto head = reading->program.ask<FeatureFileHead>({Task::OpenFeatures, {path}});
    if (!head)
        return head.problems();
    reading->head = std::move(head.value());
    return VectorFile(std::move(reading));
}

const std::string& VectorFile::path() const {
    return _reading->path;
}

const std::string& VectorFile::format() const {
    return _reading->head.format;
}

std::vector<std::string> VectorFile::layers() const {
    return _reading->head.layers;
}

Diagnostics VectorFile::chooseLayer(const std::string& layer) {
    _reading->stop();
    auto chosen = _reading->program.ask<FeatureLayer>({Task::ChooseLayer, {layer}});
    if (!chosen)
        return chosen.problems();
    _reading->layer = std::move(chosen.value());
    _reading->crs.reset();
    if (const auto& facts = _reading->layer.crs)
        _reading->crs = Crs(*facts);
    rewind();
    return {};
}

Diagnostics VectorFile::filter(const std::string& condition) {
    _reading->stop();
    const auto filtered = _reading->program.ask<MapDone>({Task::FilterFeatures, {condition}});
    if (filtered)
        rewind(_reading->way, _reading->columns);
    return filtered.problems();
}

const std::vector<std::string>& VectorFile::columns() const {
    return _reading->layer.columns;
}

const std::optional<Crs>& VectorFile::crs() const {
    return _reading->crs;
}

bool VectorFile::hasGeometry() const {
    return _reading->layer.hasGeometry;
}

const std::vector<std::string>& VectorFile::warnings() const {
    return _reading->head.warnings;
}

void VectorFile::rewind(const CrsWay& way, std::vector<std::size_t> columns) {
    Reading& reading = *_reading;
    reading.stop();
    reading.way = way;
    reading.columns = std::move(columns);
    reading.slots.resize(reading.layer.columns.size());
    for (std::size_t i = 0; i < reading.slots.size(); ++i) {
        const auto found = std::find(reading.columns.begin(), reading.columns.end(), i);
        reading.slots[i] =
            reading.columns.empty() ? i : static_cast<std::size_t>(found - reading.columns.begin());
    }
    reading.batch = {};
    reading.index = 0;
    const auto done = reading.program.ask<MapDone>(
        {Task::RewindFeatures, {way.from().text(), way.to().text()}, {}, reading.columns});
    if (done)
        reading.ask();
    else
        reading.problems = done.problems();
}

Result<bool> VectorFile::next() {
    Reading& reading = *_reading;
    while (reading.index >= reading.batch.ids.size()) {
        if (!reading.problems.empty())
            return reading.problems;
        if (!reading.batch.problem.empty())
            return fileProblem(reading.path, reading.batch.problem);
        if (!reading.isAsked)
            return false;
        if (reading.take() && !reading.batch.isLast)
            reading.ask();
    }
    ++reading.index;
    return true;
}

std::string VectorFile::feature() const {
    const std::string& layer = _reading->layer.where;
    return layer + (layer.empty() ? "" : ", ") + "feature " +
           std::to_string(_reading->batch.ids[_reading->index - 1]);
}

bool VectorFile::has(std::size_t column) const {
    const FeatureBatch::Column* all = _reading->column(column);
    return all && all->kinds[_reading->index - 1] != FeatureBatch::Missing;
}

std::string VectorFile::text(std::size_t column) const {
    const FeatureBatch::Column* all = _reading->column(column);
    if (!all)
        return {};
    const std::size_t i = _reading->index - 1, begin = i == 0 ? 0 : all->ends[i - 1];
    return all->texts.substr(begin, all->ends[i] - begin);
}

std::optional<double> VectorFile::number(std::size_t column) const {
    const FeatureBatch::Column* all = _reading->column(column);
    if (!all || all->kinds[_reading->index - 1] != FeatureBatch::Number)
        return std::nullopt;
    return all->numbers[_reading->index - 1];
}

Result<VectorPlace> VectorFile::place() const {
    const std::size_t index = _reading->index - 1;
    const auto& placeless = _reading->batch.placeless;
    const auto found = std::lower_bound(
        placeless.begin(), placeless.end(), index,
        [](const FeatureBatch::Placeless& one, std::size_t other) { return one.index < other; });
    if (found != placeless.end() && found->index == index)
        return keyProblem("", found->message);
    return _reading->batch.places[index];
}

} // namespace osgTreeWind
