// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>

#include <climits>
#include <cmath>
#include <limits>
#include <random>

namespace osgTreeWind {

/// Random values, valid and invalid, as a faulty host may pass them.
class RandomValues {
public:
    explicit RandomValues(unsigned seed) : _random(seed) {}

    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(_random);
    }
    bool oneIn(std::size_t count) { return below(count) == 0; }
    template <typename T>
    T number() {
        using Limits = std::numeric_limits<T>;
        const T numbers[] = {Limits::quiet_NaN(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             T(-0.0),
                             T(0.0),
                             Limits::denorm_min(),
                             -Limits::denorm_min(),
                             T(1e30),
                             T(-1e30),
                             Limits::max(),
                             Limits::lowest(),
                             T(-1.0),
                             T(1.0),
                             T(0.5),
                             T(1000.0)};
        return numbers[below(std::size(numbers))];
    }
    int integer() {
        const int numbers[] = {INT_MIN, INT_MAX, -1, 0, 1, 2, 1000000000};
        return numbers[below(std::size(numbers))];
    }
    std::uint32_t count() { return static_cast<std::uint32_t>(integer()); }
    /// An empty string, a word, or a very long string of a random byte.
    std::string text() {
        return oneIn(3)   ? std::string()
               : oneIn(2) ? std::string("oak")
                          : std::string(1 + below(100000), char(below(256)));
    }
    template <typename T>
    glm::vec<3, T> vector() {
        return {number<T>(), number<T>(), number<T>()};
    }

    /// Sets one key of a struct to a random value.
    void corrupt(const Keys& keys, void* owner) {
        const Key& key = keys[below(keys.size())];
        std::visit(Corrupt{*this, key}, key.member(owner));
    }
    template <typename Struct>
    void corrupt(Struct& value) {
        corrupt(keysOf<Struct>(), &value);
    }

private:
    struct Corrupt {
        RandomValues& any;
        const Key& key;

        /// Either end of the range, or the given number.
        template <typename T>
        T numberInRange(T other) const {
            const Range range = std::is_same_v<T, double> ? key.range : memberRange(key);
            return any.oneIn(3)   ? static_cast<T>(range.min)
                   : any.oneIn(3) ? static_cast<T>(range.max)
                                  : other;
        }
        void operator()(bool* member) const { *member = any.oneIn(2); }
        template <typename T>
        void operator()(std::optional<T>* member) const {
            (*this)(&member->emplace());
        }
        void operator()(int* member) const {
            const bool isOpen = key.range.max > INT_MAX || any.oneIn(3);
            *member = isOpen ? any.integer() : static_cast<int>(any.oneIn(2) ? key.range.min : key.range.max);
        }
        void operator()(std::uint32_t* member) const { *member = any.count(); }
        void operator()(float* member) const { *member = numberInRange(any.number<float>()); }
        void operator()(double* member) const { *member = numberInRange(any.number<double>()); }
        template <typename T>
        void operator()(glm::vec<3, T>* member) const {
            const int axis = static_cast<int>(any.below(3));
            if constexpr (std::is_integral_v<T>)
                (*member)[axis] = any.integer();
            else
                (*member)[axis] = any.number<T>();
        }
        void operator()(std::array<float, 4>* member) const {
            (*member)[any.below(4)] = numberInRange(any.number<float>());
        }
        void operator()(std::string* member) const { *member = any.text(); }
        template <typename T>
        void operator()(std::vector<T>* member) const {
            member->resize(any.oneIn(2) ? 0 : any.below(100000));
            if constexpr (std::is_arithmetic_v<T>)
                if (!member->empty())
                    (*member)[any.below(member->size())] = any.number<T>();
        }
        void operator()(const EnumMember& word) const { word.set(word.object, any.integer()); }
        void operator()(const NestedMember& part) const { any.corrupt(*part.keys, part.object); }
    };

    std::mt19937 _random;
};

} // namespace osgTreeWind
