// The surface under a face as integrals.cpp sums over it; only for that file.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <math.hxx>
#include <math_Vector.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shim.h"

namespace assemcad {

// Area, its first moment; volume, its first moment, xx, yy, zz, xy, yz, zx.
inline constexpr std::size_t AREA = 0, VOLUME = 4, FIRST = 5, SECOND = 8, COUNT = 14;
using Sums = std::array<double, COUNT>;
// The power of a length that each of them is.
inline constexpr std::array<int, COUNT> POWERS{2, 3, 3, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5, 5};

inline void add(const Sums& more, double times, Sums& out) {
  for (std::size_t i = 0; i < COUNT; ++i) {
    out[i] += times * more[i];
  }
}

struct Rule {
  std::vector<double> x, w;
};

// Gauss's points and weights from -1 to 1, taken from OCCT's tables.
inline const Rule& gauss(int n) {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> all(33);
    for (int k = 1; k < static_cast<int>(all.size()); ++k) {
      math_Vector x(1, k), w(1, k);
      math::OrderedGaussPointsAndWeights(k, x, w);
      for (int i = 1; i <= k; ++i) {
        all[k].x.push_back(x(i));
        all[k].w.push_back(w(i));
      }
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(n)];
}

// Into how many parts with how many points an interval is divided.
struct Division {
  int parts, points;
};

// What integrates sines of up to `frequency` over an angle to 4e-15: tried out for cos(k x) from -1 to
// 1 with all k up to 16, above which the interval is divided.
inline Division waves(double frequency, double angle) {
  const double phase = 0.5 * frequency * std::abs(angle);
  // Written so that NaN fails too.
  if (!(phase < 1e4)) {
    throw Invalid("a face winds about its axis without end");
  }
  const int parts = std::max(1, static_cast<int>(std::ceil(phase / 16.0)));
  const double each = phase / parts;
  return {parts, static_cast<int>(std::ceil(0.5 * each + 4.0 + 2.6 * std::sqrt(each)))};
}

// A surface: points less the origin, and normals Su x Sv.
struct Ground {
  // Plane; a line or a circle turned about an axis; an extrusion; anything else.
  enum Sort { FLAT, LATHED, RINGED, RULED, FREE };

  BRepAdaptor_Surface surface;
  Sort sort = FREE;
  gp_XYZ origin, o, x, y, z, normal;
  // Of what is turned: r + v * s and v * c, or r + s * cos(v) and s * sin(v).
  double r = 0.0, s = 0.0, c = 1.0;
  // Knot lines of the surface.
  std::vector<double> us, vs;
  long points = 0;

  Ground(const TopoDS_Face& face, const gp_XYZ& from) : surface(face, Standard_False), origin(from) {
    switch (surface.GetType()) {
      case GeomAbs_Plane:
        turned(FLAT, surface.Plane().Position());
        break;
      case GeomAbs_Cylinder:
        turned(LATHED, surface.Cylinder().Position());
        r = surface.Cylinder().Radius();
        break;
      case GeomAbs_Cone:
        turned(LATHED, surface.Cone().Position());
        r = surface.Cone().RefRadius();
        s = std::sin(surface.Cone().SemiAngle());
        c = std::cos(surface.Cone().SemiAngle());
        break;
      case GeomAbs_Sphere:
        turned(RINGED, surface.Sphere().Position());
        s = surface.Sphere().Radius();
        break;
      case GeomAbs_Torus:
        // The area of one that crosses its axis has a kink there: no sum of sines.
        if (surface.Torus().MajorRadius() > surface.Torus().MinorRadius()) {
          turned(RINGED, surface.Torus().Position());
          r = surface.Torus().MajorRadius();
          s = surface.Torus().MinorRadius();
        }
        break;
      case GeomAbs_SurfaceOfExtrusion:
        sort = RULED;
        us = lines(true);
        break;
      default:
        us = lines(true);
        vs = lines(false);
    }
  }

  void turned(Sort as, const gp_Ax3& at) {
    sort = as;
    o = at.Location().XYZ() - origin;
    x = at.XDirection().XYZ();
    y = at.YDirection().XYZ();
    z = at.Direction().XYZ();
    // Not z: the axes may be left-handed.
    normal = x.Crossed(y);
  }

  std::vector<double> lines(bool along_u) const {
    const int n = along_u ? surface.NbUIntervals(GeomAbs_CN) : surface.NbVIntervals(GeomAbs_CN);
    TColStd_Array1OfReal values(1, n + 1);
    along_u ? surface.UIntervals(values, GeomAbs_CN) : surface.VIntervals(values, GeomAbs_CN);
    std::vector<double> out;
    for (int i = 2; i <= n; ++i) {
      out.push_back(values(i));
    }
    if (!(along_u ? surface.IsUPeriodic() : surface.IsVPeriodic())) {
      return out;
    }
    // Borders may lie one period further on, and the seam is a knot line too.
    const double period = along_u ? surface.UPeriod() : surface.VPeriod();
    out.insert(out.begin(), values(1));
    std::vector<double> repeated;
    for (const int turn : {-1, 0, 1}) {
      for (const double value : out) {
        repeated.push_back(value + turn * period);
      }
    }
    repeated.push_back(repeated.front() + 3 * period);
    return repeated;
  }

  Division across(double width, int n, int parts) const {
    switch (sort) {
      case FLAT:
      case RULED:
        // At most cubes: points run linearly, normals stand.
        return {1, 2};
      case LATHED:
        // One power more on cones, where normals grow with the radius.
        return {1, 3};
      case RINGED:
        // At most three coordinates, and the radius and a component of the normal.
        return waves(5.0, width);
      default:
        return {parts, n};
    }
  }

  // Adds w times the integral over v at one u.
  void line(double u, double from, double to, double w, int n, int parts, Sums& out) {
    const Division division = across(to - from, n, parts);
    const Rule& rule = gauss(division.points);
    const double half = 0.5 * (to - from) / division.parts;
    const double cu = std::cos(u), su = std::sin(u);
    const gp_XYZ e = x * cu + y * su;
    const gp_XYZ side = (y * cu - x * su).Crossed(z);
    points += division.parts * division.points;
    gp_Pnt p;
    gp_Vec du, dv;
    for (int part = 0; part < division.parts; ++part) {
      const double middle = from + (2 * part + 1) * half;
      for (std::size_t i = 0; i < rule.x.size(); ++i) {
        const double v = middle + half * rule.x[i];
        const double weight = w * half * rule.w[i];
        switch (sort) {
          case FLAT:
            weigh(o + x * u + y * v, normal, weight, out);
            break;
          case LATHED: {
            const double radius = r + v * s;
            weigh(o + e * radius + z * (v * c), (side * c - normal * s) * radius, weight, out);
            break;
          }
          case RINGED: {
            const double cv = s * std::cos(v), sv = s * std::sin(v);
            weigh(o + e * (r + cv) + z * sv, (side * cv + normal * sv) * (r + cv), weight, out);
            break;
          }
          default:
            surface.D1(u, v, p, du, dv);
            weigh(p.XYZ() - origin, du.XYZ().Crossed(dv.XYZ()), weight, out);
        }
      }
    }
  }

  static void weigh(const gp_XYZ& p, const gp_XYZ& n, double w, Sums& out) {
    const double area = w * n.Modulus();
    const double px = p.X(), py = p.Y(), pz = p.Z();
    const double nx = w * n.X(), ny = w * n.Y(), nz = w * n.Z();
    const double xx = px * px * nx / 2, yy = py * py * ny / 2, zz = pz * pz * nz / 2;
    const Sums more{area,          area * px,     area * py,     area * pz,
                    (px * nx + py * ny + pz * nz) / 3,           xx,
                    yy,            zz,            px * xx / 1.5, py * yy / 1.5,
                    pz * zz / 1.5, xx * py,       yy * pz,       zz * px};
    add(more, 1.0, out);
  }
};

}  // namespace assemcad
