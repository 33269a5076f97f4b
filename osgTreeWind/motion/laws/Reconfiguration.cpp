// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/Reconfiguration.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/species/SpeciesKeys.h>

namespace osgTreeWind {

Reconfiguration::Reconfiguration(const Species& species) {
    const WoodParameters wood = clampedKeys(species.wood);
    streamlining = wood.streamlining;
    breezeStreamlining = wood.breezeStreamlining;
    streamlinedTo = wood.streamlinedTo;
    maxPull = math::tan(clampedKeys(species.leaf).maxDownwind);
}

glm::vec4 Reconfiguration::pull(const glm::vec3& wind) const {
    return Laws().foliagePull(wind, streamlining, breezeStreamlining, streamlinedTo, maxPull);
}

float Reconfiguration::dragRatio(float speed) const {
    return Laws().foliageDrag(streamlining, breezeStreamlining, streamlinedTo, speed);
}

glm::quat downwindLeafTurn(const glm::quat& orientation, const glm::vec4& state, const glm::vec4& pull) {
    const glm::vec4 q =
        Laws().downwindTurn(orientation * glm::vec3(0.0f, 0.0f, 1.0f), state.w * glm::vec3(pull));
    return glm::quat(q.w, q.x, q.y, q.z) * orientation * leafRotation(state);
}

} // namespace osgTreeWind
