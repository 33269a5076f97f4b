// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/ClipRecorder.h>

#include <osg/RenderInfo>

#include <filesystem>

std::string ClipRecorder::toggle() {
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!_path.empty()) {
        const bool good = _writer && _writer->close() && _whole->commit();
        const std::string message = good ? "wrote " + _path + ", " + std::to_string(_frames) + " frames"
                                         : _path + ": cannot be written";
        _writer.reset();
        _whole.reset();
        _path.clear();
        return message;
    }
    if (!VideoWriter::available())
        return "cannot record a video: ffmpeg is not installed";
    int number = 0;
    while (std::filesystem::exists(_path = "clip_" + std::to_string(number) + ".mp4"))
        ++number;
    _frames = 0;
    return "recording " + _path;
}

double ClipRecorder::referenceTime(double elapsed) {
    const std::lock_guard<std::mutex> lock(_mutex);
    _time += _path.empty() ? elapsed - _elapsed : 1.0 / framesPerSecond;
    _elapsed = elapsed;
    return _time;
}

void ClipRecorder::operator()(osg::RenderInfo& info) const {
    const std::lock_guard<std::mutex> lock(_mutex);
    const osg::Viewport* viewport = info.getCurrentCamera()->getViewport();
    if (_path.empty() || !viewport)
        return;
    const int width = static_cast<int>(viewport->width()), height = static_cast<int>(viewport->height());
    if (!_writer) {
        _whole = std::make_unique<osgTreeWind::AtomicFile>(_path);
        _writer = std::make_unique<VideoWriter>(_whole->writePath(), width, height, framesPerSecond);
    } else if (width != _image->s() || height != _image->t())
        return; // the window was resized; a clip has one size
    _image->readPixels(static_cast<int>(viewport->x()), static_cast<int>(viewport->y()), width, height,
                       GL_RGBA, GL_UNSIGNED_BYTE);
    _frames += _writer->write(*_image);
}
