// What surfaces do to light: Fresnel's equations for metals and glass (unpolarised).

// Reflectance of a metal with complex refractive index n + i k, per channel, seen under cosTheta
// (Born & Wolf, Principles of Optics, 14.4; the closed form over real numbers).
vec3 fresnelConductor(float cosTheta, vec3 n, vec3 k) {
    float cos2 = cosTheta * cosTheta;
    float sin2 = 1.0 - cos2;
    vec3 difference = n * n - k * k - sin2;
    vec3 a2PlusB2 = sqrt(difference * difference + 4.0 * n * n * k * k);
    vec3 a = sqrt(max(0.5 * (a2PlusB2 + difference), 0.0));
    vec3 s1 = a2PlusB2 + cos2;
    vec3 s2 = 2.0 * cosTheta * a;
    vec3 rs = (s1 - s2) / (s1 + s2);
    vec3 p1 = cos2 * a2PlusB2 + sin2 * sin2;
    vec3 p2 = s2 * sin2;
    vec3 rp = rs * (p1 - p2) / (p1 + p2);
    return 0.5 * (rs + rp);
}

// Reflectance of an interface; `eta` is the index behind it over the index before it. 1 in total internal reflection,
// else cosTransmitted is set.
float fresnelDielectric(float cosIncident, float eta, out float cosTransmitted) {
    float sin2 = (1.0 - cosIncident * cosIncident) / (eta * eta);
    cosTransmitted = sqrt(max(1.0 - sin2, 0.0));
    if (sin2 >= 1.0) return 1.0;
    float rs = (cosIncident - eta * cosTransmitted) / (cosIncident + eta * cosTransmitted);
    float rp = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
    return 0.5 * (rs * rs + rp * rp);
}
