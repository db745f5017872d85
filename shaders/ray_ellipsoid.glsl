// SPDX-License-Identifier: Apache-2.0
// An ellipsoid as the rays see it, in the space in which it is the unit sphere. There a ray is from + t along; t is the
// distance along the view, 0 at the ellipsoid's centre. Both vectors change evenly over the picture: the columns of
// their matrices are for a pixel to the right, one down, and the outline's centre. So no large numbers cancel, however
// far away the camera is.
struct RayEllipsoid {
  mat3 from_S, along_S;
  mat3 toUnitSphere;
  ScreenEllipse outline;
  float distance;  // of the centre along the view
};

// The nine constants from `i` on, as append() of render/ellipsoid_rays.h lists them.
RayEllipsoid rayEllipsoid(int i) {
  vec3 middle = fourthsOf(i);
  return RayEllipsoid(ownMatrix(i), ownMatrix(i + 3), ownMatrix(i + 6), ScreenEllipse(middle.xy, fourthsOf(i + 3)), middle.z);
}

// The part of a ray inside it.
struct Chord {
  vec3 along;
  vec3 middle;     // its point nearest the centre
  float tMiddle;
  float tHalf;     // to either end; 0 beside the outline
  float along2;    // along . along
};

Chord chordOf(RayEllipsoid e, vec2 p_px) {
  vec3 q = vec3(p_px - e.outline.centre_px, 1.0), from = e.from_S * q, along = e.along_S * q;
  float along2 = dot(along, along), inverse = 1.0 / along2, t = -dot(from, along) * inverse;
  vec3 middle = from + t * along;
  return Chord(along, middle, t, sqrt(max(1.0 - dot(middle, middle), 0.0) * inverse), along2);
}

// One end of a chord.
struct ChordEnd {
  vec3 onSphere;
  vec3 normal_C;   // outwards, of any length
  float t;
  float facing;    // cosine between the surface's normal and the ray back
  vec2 slip;       // by how much of the ray a step in the picture leaves the sphere, to the right and up
};

// `end` is -1 for the one towards the eye, or 1; ray2 the square of the ray's length in C. The ray times the normal is
// the same in both spaces.
ChordEnd endOf(RayEllipsoid e, Chord c, float end, float ray2) {
  float t = end * c.tHalf, across = end * max(c.tHalf * c.along2, 1e-4);
  vec3 s = c.middle + t * c.along, n_C = s * e.toUnitSphere;
  float lengths = sqrt(ray2 * dot(n_C, n_C)), inverse = 1.0 / (across * lengths);
  return ChordEnd(s, n_C, c.tMiddle + t, across * across * abs(inverse), n_C.xy * (lengths * inverse));
}

// Where that is on the sphere. A step of the picture is size_C there. Not from the neighbours' difference, which is too
// coarse at the rim.
SpherePoint spherePoint(RayEllipsoid e, Chord c, ChordEnd at, float size_C) {
  return spherePoint(at.onSphere, size_C * (e.toUnitSphere[0] - at.slip.x * c.along),
                     -size_C * (e.toUnitSphere[1] - at.slip.y * c.along));
}
