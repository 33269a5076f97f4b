// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/FormCache.h>

#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/growth/FormDiskCache.h>
#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/growth/GrowthSourceHash.h>
#include <osgTreeWind/growth/PackedForm.h>

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <mutex>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::uint64_t maxDiskBytes = 256'000'000; // bytes
constexpr std::size_t maxHeldMetamers = 400'000;    // metamers

/// Forms by their keys. It holds the latest ones, so that counting a tree's parts and then building the tree
/// grows it only once.
class RecentForms {
public:
    template <typename Make>
    std::shared_ptr<const GrownForm> get(const std::string& key, const Make& make) {
        return _forms.get(key, [&] {
            auto made = std::make_shared<const GrownForm>(make());
            hold(made);
            return made;
        });
    }

private:
    void hold(const std::shared_ptr<const GrownForm>& form) {
        const std::lock_guard<std::mutex> lock(_mutex);
        _held.push_back(form);
        _metamers += form->metamers.size();
        while (_metamers > maxHeldMetamers) {
            _metamers -= _held.front()->metamers.size();
            _held.pop_front();
        }
    }

    SharedConstants<std::string, GrownForm> _forms;
    std::mutex _mutex; ///< Guards the rest.
    std::deque<std::shared_ptr<const GrownForm>> _held;
    std::size_t _metamers = 0;
};

GrownForm loadOrGrow(const GrowthParameters& parameters, const std::string& key) {
    const FormDiskCache cache(formCacheFolder(), maxDiskBytes);
    if (const auto bytes = cache.find(key))
        if (auto form = unpackedForm(*bytes))
            return std::move(*form);
    GrownForm form = growTree(parameters);
    cache.store(key, packedForm(form));
    return form;
}

/// Folder named by an environment variable. Empty if it is unset, or relative and so depends on the current
/// folder.
std::filesystem::path absoluteFolder(const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path folder = value ? value : "";
    return folder.is_absolute() ? folder : std::filesystem::path();
}

} // namespace

std::string formCacheFolder() {
    if (const char* wanted = std::getenv("OSGTREEWIND_FORM_CACHE"); wanted && *wanted)
        return std::string(wanted) == "off" ? std::string() : wanted;
    std::filesystem::path caches = absoluteFolder("XDG_CACHE_HOME");
    if (caches.empty() && !absoluteFolder("HOME").empty())
        caches = absoluteFolder("HOME") / ".cache";
    if (caches.empty())
        caches = absoluteFolder("LOCALAPPDATA");
    return caches.empty() ? std::string() : (caches / "osgtreewind").string();
}

std::string formKey(const GrowthParameters& parameters) {
    GrowthParameters shape = parameters;
    shape.flare = 0.0f; // shapes only the bark
    shape.habit.model.clear();
    const GrowthSite& site = shape.site;
    std::string key = growthSourceHash();
    for (const float number :
         {site.shade, site.distance, site.openSide ? 1.0f : 0.0f, site.openSide.value_or(0.0f)})
        key.append(reinterpret_cast<const char*>(&number), sizeof number);
    addKeyBytes(shape, key);
    return key;
}

std::shared_ptr<const GrownForm> grownForm(const GrowthParameters& parameters) {
    static RecentForms forms;
    const std::string key = formKey(parameters);
    return forms.get(key, [&] { return loadOrGrow(parameters, key); });
}

} // namespace osgTreeWind
