// Writes specialisation constants and what is computed from them (frozen_constants_test.cpp says what should come out).
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 1) in;
layout(constant_id = 0) const uint COUNT = 1u;
layout(constant_id = 1) const bool HAS_IT = false;
layout(constant_id = 2) const uint UNSET = 42u;

const uint SUM = COUNT * 3u + UNSET - 2u;
const uint MASK = (1u << COUNT) - 1u;
const uint REST = SUM % 5u;                           // not computed by withFrozenConstants()
const bool FEW = COUNT <= 4u && COUNT >= 1u;
const bool AT_LEAST_3 = !(COUNT < 3u);
const bool MANY = COUNT > 4u || AT_LEAST_3;
const bool SAME = HAS_IT == FEW;
const bool OTHER = (COUNT != UNSET) != HAS_IT;
const uint CHOSEN = HAS_IT ? SUM : MASK;

layout(scalar, set = 0, binding = 0) uniform Block { uint unused; };
layout(scalar, set = 0, binding = 1) buffer Result { uint words[]; };

void main() {
    words[0] = COUNT;
    words[1] = uint(HAS_IT);
    words[2] = UNSET;
    words[3] = SUM;
    words[4] = MASK;
    words[5] = REST;
    words[6] = FEW ? 1u : 0u;
    words[7] = MANY ? 1u : 0u;
    words[8] = SAME ? 1u : 0u;
    words[9] = OTHER ? 1u : 0u;
    words[10] = CHOSEN;
    words[11] = COUNT == UNSET ? 1u : 0u;
}
