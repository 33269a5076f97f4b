// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/VectorFile.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/Unicode.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

using Task = MapRequest::Task;

/// The program reads ahead while the caller uses the current batch.
void VectorFile::requestBatch() {
    _program->send({Task::NextFeatures});
    _isBatchPending = true;
}

/// Receives the requested batch. @return false on an error.
bool VectorFile::receiveBatch() {
    auto received = _program->receiveNext<FeatureBatch>();
    _isBatchPending = false;
    _index = 0;
    _batch = received ? std::move(received.value()) : FeatureBatch();
    if (!received)
        _problems = received.problems();
    for (FeatureBatch::Column& column : _batch.columns)
        if (!isUtf8(column.texts))
            recode(column);
    return received.ok();
}

/// Converts the texts of a column to UTF-8, with a warning for the first.
void VectorFile::recode(FeatureBatch::Column& column) {
    std::string texts;
    std::size_t begin = 0;
    for (std::uint32_t& end : column.ends) {
        texts += asUtf8(column.texts.substr(begin, end - begin));
        begin = end;
        end = static_cast<std::uint32_t>(texts.size());
    }
    column.texts = std::move(texts);
    noteRecoding();
}

void VectorFile::noteRecoding() {
    if (!_isRecoded)
        _header.warnings.push_back("is no UTF-8 and is read as Windows-1252" +
                                   std::string(format() == "ESRI Shapefile"
                                                   ? "; a .cpg file beside it would name another encoding"
                                                   : ""));
    _isRecoded = true;
}

/// Receives a pending batch so that the program can receive the next request.
void VectorFile::discardPendingBatch() {
    if (_isBatchPending)
        receiveBatch();
}

/// Null for a column that was not requested.
const FeatureBatch::Column* VectorFile::column(std::size_t column) const {
    return _batchColumns[column] < _batch.columns.size() ? &_batch.columns[_batchColumns[column]] : nullptr;
}

bool VectorFile::isSupported(const std::string& path) {
    if (lower(extensionOf(path)) == ".csv")
        return false;
    const auto isSupported = MapProgram({path}).request<bool>({Task::DetectFeatures, {path}});
    return isSupported && isSupported.value();
}

Result<VectorFile> VectorFile::open(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    VectorFile file;
    file._path = path;
    file._program = std::make_unique<MapProgram>(std::vector<std::string>{path});
    auto header = file._program->request<FeatureFileHeader>({Task::OpenFeatures, {path}});
    if (!header)
        return header.problems();
    file._header = std::move(header.value());
    return Result<VectorFile>(std::move(file));
}

Diagnostics VectorFile::chooseLayer(const std::string& layer) {
    discardPendingBatch();
    auto chosen = _program->request<FeatureLayer>({Task::ChooseLayer, {layer}});
    if (!chosen)
        return chosen.problems();
    _layer = std::move(chosen.value());
    for (std::string& column : _layer.columns)
        if (!isUtf8(column)) {
            column = asUtf8(std::move(column));
            noteRecoding();
        }
    _crs.reset();
    if (const auto& facts = _layer.crs)
        _crs = Crs(*facts);
    rewind();
    return {};
}

void VectorFile::rewind(const CrsTransform& transform, std::vector<std::size_t> columns) {
    discardPendingBatch();
    _transform = transform;
    _columns = std::move(columns);
    _batchColumns.resize(_layer.columns.size());
    for (std::size_t i = 0; i < _batchColumns.size(); ++i) {
        const auto found = std::find(_columns.begin(), _columns.end(), i);
        _batchColumns[i] = _columns.empty() ? i : static_cast<std::size_t>(found - _columns.begin());
    }
    _batch = {};
    _index = 0;
    const auto done = _program->request<MapAcknowledgement>(
        {Task::RewindFeatures, {_transform.from().text(), _transform.to().text()}, {}, _columns, _isYFirst});
    if (done)
        requestBatch();
    else
        _problems = done.problems();
}

Result<bool> VectorFile::next() {
    while (_index >= _batch.ids.size()) {
        if (!_problems.empty())
            return _problems;
        if (!_batch.problem.empty())
            return fileProblem(_path, _batch.problem);
        if (!_isBatchPending)
            return false;
        if (receiveBatch() && !_batch.isLast)
            requestBatch();
    }
    ++_index;
    return true;
}

std::string VectorFile::feature() const {
    const std::string& layer = _layer.messagePrefix;
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
    const auto& placeProblems = _batch.placeProblems;
    const auto found =
        std::lower_bound(placeProblems.begin(), placeProblems.end(), index,
                         [](const PlaceProblem& problem, std::size_t i) { return problem.index < i; });
    if (found != placeProblems.end() && found->index == index)
        return keyProblem("", found->message);
    return _batch.places[index];
}

} // namespace osgTreeWind
