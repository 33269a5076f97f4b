// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/SharedValues.h>

#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgTreeWind {

/// A weak reference to an OSG object, with the interface of std::weak_ptr.
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

/// SharedValues for OSG objects.
template <typename Key, typename T>
using SharedObjects = SharedValues<Key, osg::ref_ptr<T>, WeakObject<T>>;

} // namespace osgTreeWind
