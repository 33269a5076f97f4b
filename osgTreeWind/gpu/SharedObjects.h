// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/SharedValues.h>

#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgTreeWind {

/// std::weak_ptr of an object of OSG.
template <typename T>
class WeakObject {
public:
    WeakObject& operator=(const osg::ref_ptr<T>& object) {
        _object = object;
        return *this;
    }
    osg::ref_ptr<T> lock() const {
        osg::ref_ptr<T> object;
        _object.lock(object);
        return object;
    }
    bool expired() const { return !_object.valid(); }

private:
    osg::observer_ptr<T> _object;
};

/// SharedValues of objects of OSG.
template <typename Key, typename T>
using SharedObjects = SharedValues<Key, osg::ref_ptr<T>, WeakObject<T>>;

} // namespace osgTreeWind
