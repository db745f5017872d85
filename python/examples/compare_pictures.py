#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares pictures of one scene: drawn twice, at another time, and in another style."""

import poinsot

SIZE = (320, 180)
SCENE = {"body": {"catalogue": "racket"}, "motion": {"omega_body": [0.05, 4, 0]}}


def main():
    scene = poinsot.loads(SCENE)
    picture = scene.render(1.0, size=SIZE)
    others = {
        "again": scene.render(1.0, size=SIZE),
        "5 ms later": scene.render(1.005, size=SIZE),
        "another style": scene.replace({"style.theme": "dark"}).render(1.0, size=SIZE),
    }
    for name, other in others.items():
        figures = poinsot.diff(picture, other)
        print(
            f"{name:14} {figures['verdict']:10} {figures['differing_pixels']:6} pixels"
            f"  FLIP {figures['flip']['mean']:.2e}  {figures['change'] or ''}"
        )


if __name__ == "__main__":
    main()
