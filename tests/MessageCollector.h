// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Notify>
#include <osg/ref_ptr>

#include <mutex>
#include <string>
#include <utility>

/// Collects OSG's messages at NOTICE and above. Ignores the progress of growing a forest, which is reported
/// after a second and so depends on the machine. Thread-safe.
class MessageCollector : public osg::NotifyHandler {
public:
    void notify(osg::NotifySeverity severity, const char* message) override {
        const std::lock_guard<std::mutex> lock(_mutex);
        const bool isProgress = std::string(message).rfind("osgTreeWind: growing a forest", 0) == 0;
        if (severity <= osg::NOTICE && !isProgress)
            _messages += message;
    }
    /// Returns and clears the collected messages.
    std::string take() {
        const std::lock_guard<std::mutex> lock(_mutex);
        return std::exchange(_messages, std::string());
    }

private:
    std::mutex _mutex;
    std::string _messages;
};

/// Sets a MessageCollector as OSG's notify handler during its lifetime.
class ScopedMessages {
public:
    ScopedMessages() : _former(osg::getNotifyHandler()) { osg::setNotifyHandler(_collector); }
    ~ScopedMessages() { osg::setNotifyHandler(_former); }
    ScopedMessages(const ScopedMessages&) = delete;
    ScopedMessages& operator=(const ScopedMessages&) = delete;
    std::string take() const { return _collector->take(); }

private:
    osg::ref_ptr<MessageCollector> _collector = new MessageCollector;
    osg::ref_ptr<osg::NotifyHandler> _former;
};
