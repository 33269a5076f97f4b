// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/FormCache.h>

#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/base/SourceHashes.h>
#include <osgTreeWind/base/UserCache.h>
#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/growth/PackedForm.h>

#include <deque>
#include <mutex>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t maxHeldMetamers = 400'000; // metamers

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
    const DiskCache cache = userCache();
    if (const auto bytes = cache.find(key))
        if (auto form = unpackedForm(*bytes))
            return std::move(*form);
    GrownForm form = growTree(parameters);
    cache.store(key, packedForm(form));
    return form;
}

} // namespace

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
