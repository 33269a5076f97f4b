// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace osgTreeWind {

/// Values made from what their keys say, each of them once for as long as somebody holds it. Any thread, any
/// time: one makes a value, others that ask for it wait.
template <typename Key, typename Pointer, typename Weak>
class SharedValues {
public:
    /// The value of a key; null where `make` returns null.
    /// @param make makes it and uses no other value of these. Where it throws or returns null, it is called
    /// again for the next one who asks.
    template <typename Make>
    Pointer get(const Key& key, const Make& make) {
        const std::shared_ptr<Entry> entry = entryOf(key);
        const std::lock_guard<std::mutex> lock(entry->mutex);
        Pointer value = entry->value.lock();
        if (!value) {
            value = make();
            entry->value = value;
        }
        return value;
    }

    /// The value of a key; null while nobody holds it.
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

    std::shared_ptr<Entry> entryOf(const Key& key) {
        const std::lock_guard<std::mutex> lock(_mutex);
        const auto found = _entries.find(key);
        if (found != _entries.end())
            return found->second;
        forget();
        return _entries.emplace(key, std::make_shared<Entry>()).first->second;
    }

    /// Drops entries whose values are gone and that no thread is about to fill.
    void forget() {
        for (auto next = _entries.begin(); next != _entries.end();)
            next = next->second.use_count() == 1 && isGone(*next->second) ? _entries.erase(next)
                                                                          : std::next(next);
    }
    static bool isGone(Entry& entry) {
        const std::lock_guard<std::mutex> lock(entry.mutex);
        return entry.value.expired();
    }

    std::mutex _mutex; ///< Guards the map; locked before an entry's.
    std::map<Key, std::shared_ptr<Entry>> _entries;
};

/// Such values by std::shared_ptr.
template <typename Key, typename Value>
using SharedConstants = SharedValues<Key, std::shared_ptr<const Value>, std::weak_ptr<const Value>>;

} // namespace osgTreeWind
