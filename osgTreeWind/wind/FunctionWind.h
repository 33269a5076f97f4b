// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

#include <functional>

namespace osgTreeWind {

/// A wind computed by a callable: a formula, or the coupling to a running simulation.
///
///     report(forest->setWind(std::make_shared<FunctionWind>([](const glm::vec3& place, double time) {
///         return glm::vec3(5.0 + std::sin(time - 0.1 * place.x), 0.0, 0.0);
///     })));
class OSGTREEWIND_EXPORT FunctionWind final : public WindField {
public:
    /// Velocity (m/s, the direction the air moves toward) at a scene position (metres; z is not the height
    /// above the ground) and time (s). Called from several threads at once. If it throws, the forest stops
    /// moving for good, with a warning.
    using Function = std::function<glm::vec3(const glm::vec3& position, double time)>;

    /// @param function may be empty: the wind is then calm.
    explicit FunctionWind(Function function);

    /// The result of the function; calm if a component is not finite.
    glm::vec3 velocity(const WindPlace& place, double time) const override;

private:
    Function _function;
};

} // namespace osgTreeWind
