// The tree of shapes (src/compile/tree.hpp): what a ray meets of the kinds that have more than FEW. The same distances, and
// of equal ones the same shape, as the loop over all of them finds.

#if TREE
layout(set = 0, binding = 19) uniform utextureBuffer treeTexels;
layout(set = 0, binding = 20) uniform utexture2D treeImage;

uvec4 treeTexel(uint at) {
    if (TEXELS_IN_IMAGES != 0u) return texelFetch(treeImage, placeInImage(at), 0);
    return texelFetch(treeTexels, int(at));
}

const uint TREE_END = 0xffffffffu;

// Where the ray enters a box, or INFINITY if it meets nothing of it nearer than tMax. The factor covers the rounding of the
// distances.
float enterBox(vec3 low, vec3 high, vec3 o, vec3 inverse, float tMax) {
    vec3 a = (low - o) * inverse;
    vec3 b = (high - o) * inverse;
    vec3 enter = min(a, b);
    vec3 leave = max(a, b);
    float near = max(max(enter.x, enter.y), max(enter.z, 0.0));
    float far = min(min(leave.x, leave.y), min(leave.z, tMax));
    return near <= far * 1.000001 ? near : INFINITY;
}

// Distance to the shape that a leaf stands for.
float hitLeaf(uint kind, uint i, vec3 o, vec3 d) {
    float t = NO_HIT;
#define HIT_KIND(KIND, COUNT, CASTERS, ARRAY, DISTANCE) \
    if (KIND != PLANE && COUNT > FEW && kind == KIND) t = DISTANCE;
    FOR_EACH_KIND(HIT_KIND)
    return t;
}

// The nearest of the hit so far and those in the tree; with `any`, as soon as something is nearer than the hit so far.
void hitTree(vec3 o, vec3 d, bool any, inout Hit hit) {
    // A ray parallel to a face: any tiny slope gives the right side without 0/0.
    vec3 inverse = 1.0 / mix(d, vec3(1e-30), lessThan(abs(d), vec3(1e-30)));
    uint waiting[TREE_DEPTH + 1u];
    uint waitingCount = 0u;
    uint at = 0u;
    for (;;) {
        while (at < TREE_LEAF) {
            uvec4 lowLeft = treeTexel(4u * at);
            uvec4 highLeft = treeTexel(4u * at + 1u);
            uvec4 lowRight = treeTexel(4u * at + 2u);
            uvec4 highRight = treeTexel(4u * at + 3u);
            float left = enterBox(uintBitsToFloat(lowLeft.xyz), uintBitsToFloat(highLeft.xyz), o, inverse, hit.t);
            float right = enterBox(uintBitsToFloat(lowRight.xyz), uintBitsToFloat(highRight.xyz), o, inverse, hit.t);
            bool rightFirst = right < left;
            at = rightFirst ? highLeft.w : lowLeft.w;
            if (max(left, right) < INFINITY) waiting[waitingCount++] = rightFirst ? lowLeft.w : highLeft.w;
            if (min(left, right) == INFINITY) at = waitingCount > 0u ? waiting[--waitingCount] : TREE_END;
        }
        if (at == TREE_END) break;
        uint kind = (at & ~TREE_LEAF) >> TREE_KIND_SHIFT;
        uint i = at & ((1u << TREE_KIND_SHIFT) - 1u);
        float t = hitLeaf(kind, i, o, d);
        bool isFirst = kind < hit.kind || (kind == hit.kind && i < hit.index);
        if (t > 0.0 && (t < hit.t || (t == hit.t && isFirst))) {
            hit = Hit(t, kind, i);
            if (any) break;
        }
        at = waitingCount > 0u ? waiting[--waitingCount] : TREE_END;
    }
}
#endif
