// From a place in the picture to a ray. A spectrum is of the line through the picture's middle, in
// each row another band.

Path cameraRay(vec2 place, uint pixelSeed, uint sampleIndex) {
    vec2 ndc = vec2(2.0 * place.x / float(scene.frame.width) - 1.0, 1.0 - 2.0 * place.y / float(scene.frame.height));
    if (IS_SPECTRUM != 0u) ndc.y = 0.0;
    Camera camera = scene.frame.camera;
    vec3 onPlane = ndc.x * camera.right + ndc.y * camera.up;
    vec3 origin = camera.position;
    vec3 direction;
    if (IS_ORTHOGRAPHIC != 0u) {
        origin += onPlane;
        direction = camera.forward;
    } else if (HAS_LENS != 0u) {
        vec2 random = HAS_SEVERAL_SAMPLES != 0u ? samplePair(pixelSeed, sampleIndex, 1u) : vec2(0.5);
        vec2 onLens = sampleRing(random, 0.0);
        vec3 fromCentre = onLens.x * camera.lensRight + onLens.y * camera.lensUp;
        origin += fromCentre;
        direction = normalize((camera.forward + onPlane) * camera.focusDistance - fromCentre);
    } else {
        direction = normalize(camera.forward + onPlane);
    }
    throughput.band[0] = 1.0;
    throughput.bands = 0u;
    if (IS_SPECTRUM != 0u) {
        [[dont_unroll]] for (uint k = 0u; k < BANDS; ++k) throughput.band[k] = k == uint(place.y) ? 1.0 : 0.0;
        throughput.bands = BANDS;
    }
    return Path(origin, direction, 0u, 0.0);
}
