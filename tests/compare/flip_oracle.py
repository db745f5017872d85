# SPDX-License-Identifier: Apache-2.0
# Computes FLIP a second time, directly from its definition (src/compare/flip.h names the paper), with full
# two-dimensional kernels and Python's floats. Prints the expected values of flip_pairs_test.cpp.
#   python3 tests/compare/flip_oracle.py
import math

PPD = 3840 * math.pi / 180
W, H = 32, 24


def pictures():
    """Returns the pairs of pictures: name, a(x, y), b(x, y). The test has the same formulas."""
    def hashed(x, y, c, seed):
        v = (x * 73856093 ^ y * 19349663 ^ c * 83492791 ^ seed * 2654435761) & 0xFFFFFFFF
        v = (v ^ (v >> 13)) * 1274126177 & 0xFFFFFFFF
        return (v ^ (v >> 16)) & 255

    def noise(seed):
        return lambda x, y: tuple(hashed(x, y, c, seed) for c in range(3))

    def ramp(x, y):
        return (8 * x, 10 * y, 255 - 4 * (x + y))

    def ramp_one_up(x, y):
        return tuple(min(v + 1, 255) for v in ramp(x, y))

    def disc(cx):
        return lambda x, y: (200, 40, 30) if (x - cx) ** 2 + (y - 12) ** 2 <= 49 else (250, 250, 245)

    def dot(x, y):
        return (255, 255, 255) if (x, y) == (20, 9) else ramp(x, y)

    return [('noise', noise(1), noise(2)), ('one_up', ramp, ramp_one_up), ('shifted_disc', disc(15), disc(16)),
            ('white_dot', ramp, dot), ('dark_and_light', lambda x, y: (3, 5, 9), ramp)]


def linear(v):
    c = v / 255
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


M = [[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
     [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
     [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]]
WHITE = [sum(row) for row in M]


def xyz(rgb):
    return [sum(m * v for m, v in zip(row, rgb)) / w for row, w in zip(M, WHITE)]


def solve(m, v):
    """Solves m x = v by Cramer's rule."""
    def det(a):
        return (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
                + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]))
    out = []
    for k in range(3):
        a = [row[:] for row in m]
        for r in range(3):
            a[r][k] = v[r]
        out.append(det(a) / det(m))
    return out


def opponent(rgb):
    x, y, z = xyz(rgb)
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)]


def back(o):
    y = (o[0] + 16) / 116
    v = [(y + o[1] / 500) * WHITE[0], y * WHITE[1], (y - o[2] / 200) * WHITE[2]]
    return [min(max(c, 0.0), 1.0) for c in solve(M, v)]


def hunt_lab(rgb):
    def f(t):
        d = 6 / 29
        return t ** (1 / 3) if t > d ** 3 else t / (3 * d * d) + 4 / 29
    x, y, z = map(f, xyz(rgb))
    L = 116 * y - 16
    return [L, 0.01 * L * 500 * (x - y), 0.01 * L * 200 * (y - z)]


def hyab(a, b):
    return abs(a[0] - b[0]) + math.hypot(a[1] - b[1], a[2] - b[2])


def clamped(grid, x, y):
    return grid[min(max(y, 0), H - 1)][min(max(x, 0), W - 1)]


def convolve(grid, kernel, r):
    return [[sum(kernel[j + r][i + r] * clamped(grid, x + i, y + j) for j in range(-r, r + 1) for i in range(-r, r + 1))
             for x in range(W)] for y in range(H)]


def sensitivity(parts, r):
    k = [[sum(a * math.sqrt(math.pi / b) * math.exp(-math.pi ** 2 * ((i / PPD) ** 2 + (j / PPD) ** 2) / b)
              for a, b in parts) for i in range(-r, r + 1)] for j in range(-r, r + 1)]
    total = sum(map(sum, k))
    return [[v / total for v in row] for row in k]


def signed(k):
    p = sum(v for row in k for v in row if v > 0)
    n = -sum(v for row in k for v in row if v < 0)
    return [[v / p if v > 0 else v / n for v in row] for row in k]


def features(lum):
    s = 0.5 * 0.082 * PPD
    r = math.ceil(3 * s)
    g = lambda i, j: math.exp(-(i * i + j * j) / (2 * s * s))
    span = range(-r, r + 1)
    dx = signed([[-i * g(i, j) for i in span] for j in span])
    qx = signed([[(i * i / (s * s) - 1) * g(i, j) for i in span] for j in span])
    flipped = lambda k: [list(c) for c in zip(*k)]
    length = lambda k: [[math.hypot(p, q) for p, q in zip(*rows)]
                        for rows in zip(convolve(lum, k, r), convolve(lum, flipped(k), r))]
    return length(dx), length(qx)


def seen(picture):
    o = [[opponent([linear(v) for v in picture(x, y)]) for x in range(W)] for y in range(H)]
    r = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * PPD)
    blurred = [convolve([[p[c] for p in row] for row in o], sensitivity(parts, r), r)
               for c, parts in enumerate([[(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]])]
    lab = [[hunt_lab(back([blurred[c][y][x] for c in range(3)])) for x in range(W)] for y in range(H)]
    return lab, features([[(p[0] + 16) / 116 for p in row] for row in o])


def flip(a, b):
    (la, (ea, pa)), (lb, (eb, pb)) = seen(a), seen(b)
    cmax = hyab(hunt_lab([0, 1, 0]), hunt_lab([0, 0, 1])) ** 0.7
    k = 0.4 * cmax
    out = []
    for y in range(H):
        for x in range(W):
            c = hyab(la[y][x], lb[y][x]) ** 0.7
            ec = 0.95 * c / k if c < k else 0.95 + 0.05 * (c - k) / (cmax - k)
            ef = math.sqrt(max(abs(ea[y][x] - eb[y][x]), abs(pa[y][x] - pb[y][x])) / math.sqrt(2))
            out.append(ec ** (1 - ef))
    return out


def weighted(values, q):
    total, s = sum(values), 0.0
    for v in sorted(values):
        s += v
        if s > q * total:
            return v
    return 0.0


for name, a, b in pictures():
    e = flip(a, b)
    figures = [sum(e) / len(e), min(e), weighted(e, 0.25), weighted(e, 0.5), weighted(e, 0.75), max(e), e[9 * W + 20]]
    print('{"%s", {%s}},' % (name, ', '.join('%.12g' % v for v in figures)))
