// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/VectorFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

using Task = MapQuestion::Task;

/// The program reads on while the features before are used.
void VectorFile::ask() {
    _program->send({Task::NextFeatures});
    _isAsked = true;
}

/// Takes the batch that was asked for. False where it does not come.
bool VectorFile::take() {
    auto received = _program->get<FeatureBatch>();
    _isAsked = false;
    _index = 0;
    _batch = received ? std::move(received.value()) : FeatureBatch();
    if (!received)
        _problems = received.problems();
    return received.ok();
}

/// Takes what is on its way, so that the program hears the next question.
void VectorFile::stop() {
    if (_isAsked)
        take();
}

/// Null for one that was not asked for.
const FeatureBatch::Column* VectorFile::column(std::size_t column) const {
    return _slots[column] < _batch.columns.size() ? &_batch.columns[_slots[column]] : nullptr;
}

bool VectorFile::knows(const std::string& path) {
    if (lower(std::filesystem::path(path).extension().string()) == ".csv")
        return false;
    const auto known = MapProgram({path}).ask<bool>({Task::KnowFeatures, {path}});
    return known && known.value();
}

Result<VectorFile> VectorFile::open(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    VectorFile file;
    file._path = path;
    file._program = std::make_unique<MapProgram>(std::vector<std::string>{path});
    auto head = file._program->ask<FeatureFileHead>({Task::OpenFeatures, {path}});
    if (!head)
        return head.problems();
    file._head = std::move(head.value());
    return Result<VectorFile>(std::move(file));
}

Diagnostics VectorFile::chooseLayer(const std::string& layer) {
    stop();
    auto chosen = _program->ask<FeatureLayer>({Task::ChooseLayer, {layer}});
    if (!chosen)
        return chosen.problems();
    _layer = std::move(chosen.value());
    _crs.reset();
    if (const auto& facts = _layer.crs)
        _crs = Crs(*facts);
    rewind();
    return {};
}

void VectorFile::rewind(const CrsWay& way, std::vector<std::size_t> columns) {
    stop();
    _way = way;
    _columns = std::move(columns);
    _slots.resize(_layer.columns.size());
    for (std::size_t i = 0; i < _slots.size(); ++i) {
        const auto found = std::find(_columns.begin(), _columns.end(), i);
        _slots[i] = _columns.empty() ? i : static_cast<std::size_t>(found - _columns.begin());
    }
    _batch = {};
    _index = 0;
    const auto done =
        _program->ask<MapDone>({Task::RewindFeatures, {_way.from().text(), _way.to().text()}, {}, _columns});
    if (done)
        ask();
    else
        _problems = done.problems();
}

Result<bool> VectorFile::next() {
    while (_index >= _batch.ids.size()) {
        if (!_problems.empty())
            return _problems;
        if (!_batch.problem.empty())
            return fileProblem(_path, _batch.problem);
        if (!_isAsked)
            return false;
        if (take() && !_batch.isLast)
            ask();
    }
    ++_index;
    return true;
}

std::string VectorFile::feature() const {
    const std::string& layer = _layer.where;
    return layer + (layer.empty() ? "" : ", ") + "feature " + std::to_string(_batch.ids[_index - 1]);
}

bool VectorFile::has(std::size_t column) const {
    const FeatureBatch::Column* all = this->column(column);
    return all && all->kinds[_index - 1] != FeatureBatch::Missing;
}

std::string VectorFile::text(std::size_t column) const {
    const FeatureBatch::Column* all = this->column(column);
    if (!all)
        return {};
    const std::size_t i = _index - 1, begin = i == 0 ? 0 : all->ends[i - 1];
    return all->texts.substr(begin, all->ends[i] - begin);
}

std::optional<double> VectorFile::number(std::size_t column) const {
    const FeatureBatch::Column* all = this->column(column);
    if (!all || all->kinds[_index - 1] != FeatureBatch::Number)
        return std::nullopt;
    return all->numbers[_index - 1];
}

Result<VectorPlace> VectorFile::place() const {
    const std::size_t index = _index - 1;
    const auto& placeless = _batch.placeless;
    const auto found = std::lower_bound(
        placeless.begin(), placeless.end(), index,
        [](const FeatureBatch::Placeless& one, std::size_t other) { return one.index < other; });
    if (found != placeless.end() && found->index == index)
        return keyProblem("", found->message);
    return _batch.places[index];
}

} // namespace osgTreeWind
