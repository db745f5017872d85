// SPDX-License-Identifier: Apache-2.0
// Ellipsoid as seen by the rays, in the space S in which the ellipsoid is the unit sphere. A ray there is from + t *
// along, where t is the distance along the view, 0 at the ellipsoid's centre. Both vectors are linear over the picture:
// the columns of their matrices are the change per pixel to the right, the change per pixel down, and the value at the
// outline's centre. So no large numbers cancel, even if the camera is far away.
struct RayEllipsoid {
  mat3 from_S, along_S;
  mat3 toUnitSphere;
  ScreenEllipse outline;
  float distance;  // of the centre along the view
};

// Reads the nine constants from `i` on, in the order of append() in render/ellipsoid_rays.h.
RayEllipsoid rayEllipsoid(int i) {
  vec3 middle = fourthsOf(i);
  return RayEllipsoid(ownMatrix(i), ownMatrix(i + 3), ownMatrix(i + 6), ScreenEllipse(middle.xy, fourthsOf(i + 3)), middle.z);
}

// Part of a ray inside the ellipsoid.
struct Chord {
  vec3 along;
  vec3 middle;     // the chord's point nearest the centre
  float tMiddle;
  float tHalf;     // from the middle to either end; 0 beside the outline
  float along2;    // along . along
};

Chord chordOf(RayEllipsoid e, vec2 p_px) {
  vec3 q = vec3(p_px - e.outline.centre_px, 1.0), from = e.from_S * q, along = e.along_S * q;
  float along2 = dot(along, along), inverse = 1.0 / along2, t = -dot(from, along) * inverse;
  vec3 middle = from + t * along;
  return Chord(along, middle, t, sqrt(max(1.0 - dot(middle, middle), 0.0) * inverse), along2);
}

struct ChordEnd {
  vec3 onSphere;
  vec3 normal_C;   // outwards, of any length
  float t;
  float facing;    // cosine between the surface's normal and the ray back
  vec2 slip;       // share of the ray by which a step right, or up, in the picture leaves the sphere
};

// Returns an end of the chord. `end` is -1 for the end towards the eye, or 1; ray2 is the square of the ray's length in C.
// The product of ray and normal is the same in both spaces.
ChordEnd endOf(RayEllipsoid e, Chord c, float end, float ray2) {
  float t = end * c.tHalf, across = end * max(c.tHalf * c.along2, 1e-4);
  vec3 s = c.middle + t * c.along, n_C = s * e.toUnitSphere;
  float lengths = sqrt(ray2 * dot(n_C, n_C)), inverse = 1.0 / (across * lengths);
  return ChordEnd(s, n_C, c.tMiddle + t, across * across * abs(inverse), n_C.xy * (lengths * inverse));
}

// Returns the place of a chord's end on the sphere. A step of one pixel in the picture is size_C long there. Differences
// between neighbouring pixels would be too coarse at the rim.
SpherePoint spherePoint(RayEllipsoid e, Chord c, ChordEnd at, float size_C) {
  return spherePoint(at.onSphere, size_C * (e.toUnitSphere[0] - at.slip.x * c.along),
                     -size_C * (e.toUnitSphere[1] - at.slip.y * c.along));
}
