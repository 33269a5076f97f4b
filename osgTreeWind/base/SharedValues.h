// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <map>
#include <memory>
#include <mutex>

namespace osgTreeWind {

/// A thread-safe cache of weak references. It makes the value of a key once and returns the same value for as
/// long as a caller holds it. Threads that request a value while another makes it wait.
template <typename Key, typename Pointer, typename Weak>
class SharedValues {
public:
    /// The value of a key, made if needed; null if `make` returns null.
    /// @param make makes the value without using this cache. If it fails, the next request calls it again.
    template <typename Make>
    Pointer get(const Key& key, const Make& make) {
        const std::shared_ptr<Entry> entry = findOrAddEntry(key);
        const std::lock_guard<std::mutex> lock(entry->mutex);
        Pointer value = entry->value.lock();
        if (!value) {
            value = make();
            entry->value = value;
        }
        return value;
    }

    /// The value of a key; null if no caller holds it.
    Pointer find(const Key& key) {
        std::shared_ptr<Entry> entry;
        {
            const std::lock_guard<std::mutex> lock(_mutex);
            const auto found = _entries.find(key);
            if (found == _entries.end())
                return nullptr;
            entry = found->second;
        }
        const std::lock_guard<std::mutex> lock(entry->mutex);
        return entry->value.lock();
    }

private:
    struct Entry {
        std::mutex mutex;
        Weak value;
    };

    std::shared_ptr<Entry> findOrAddEntry(const Key& key) {
        const std::lock_guard<std::mutex> lock(_mutex);
        const auto found = _entries.find(key);
        if (found != _entries.end())
            return found->second;
        removeExpired();
        return _entries.emplace(key, std::make_shared<Entry>()).first->second;
    }

    /// Removes entries that have expired and that no thread is about to fill.
    void removeExpired() {
        for (auto next = _entries.begin(); next != _entries.end();)
            next = next->second.use_count() == 1 && isExpired(*next->second) ? _entries.erase(next)
                                                                             : std::next(next);
    }
    static bool isExpired(Entry& entry) {
        const std::lock_guard<std::mutex> lock(entry.mutex);
        return entry.value.expired();
    }

    std::mutex _mutex; ///< Guards the map. Locked before the mutex of an entry.
    std::map<Key, std::shared_ptr<Entry>> _entries;
};

/// SharedValues held by std::shared_ptr.
template <typename Key, typename Value>
using SharedConstants = SharedValues<Key, std::shared_ptr<const Value>, std::weak_ptr<const Value>>;

} // namespace osgTreeWind
