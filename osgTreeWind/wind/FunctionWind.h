// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

#include <functional>

namespace osgTreeWind {

/// Any callable as a wind: a formula, or a door into a running simulator.
///
///     forest->setWind(std::make_shared<FunctionWind>([](const glm::vec3& place, double time) {
///         return glm::vec3(5.0 + std::sin(time - 0.1 * place.x), 0.0, 0.0);
///     }));
class OSGTREEWIND_EXPORT FunctionWind final : public WindField {
public:
    /// Velocity (m/s toward) at a position in the scene (metres; z is not height above the ground) and time
    /// (s). Called from any thread, several at once. A forest in a wind that throws stands still from then
    /// on, with a warning.
    using Function = std::function<glm::vec3(const glm::vec3& position, double time)>;

    /// @param function an empty one is calm.
    explicit FunctionWind(Function function);

    /// The function's answer; calm where a component of it is not finite.
    glm::vec3 velocity(const WindPlace& place, double time) const override;

private:
    Function _function;
};

} // namespace osgTreeWind
