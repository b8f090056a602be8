// Integrals over shapes, by two theorems:
//
// - the divergence theorem turns an integral over a solid into one over its faces, as in B. Mirtich,
//   "Fast and Accurate Computation of Polyhedral Mass Properties", 1996: the volume is that of P.N/3,
//   its first moment that of x^2 Nx/2, its second ones those of x^3 Nx/3 and x^2 y Nx/2;
// - Green's theorem turns an integral of f du dv over a face into -F du along its boundary in the
//   parameter plane, where F is the integral of f over v from any fixed v0.
//
// Both integrals are Gauss's sums between all knots of curves and surface. Where the integrand is a
// polynomial or a sum of sines the number of points is known beforehand; elsewhere two numbers of
// points are compared, and stretches where they differ are halved until they agree.
#include "integrals.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "ground.h"
#include "shim.h"

namespace assemcad {

namespace {

// How far two numbers of points may differ on a stretch, relative to the size of the shape.
constexpr double STILL = 1e-12;
// What may stay unsettled in all, relative to the area or the volume.
constexpr double UNSETTLED = 1e-9;
// How often a stretch is halved, and how many points a face may take (about a second's), before what
// still differs counts as unsettled.
constexpr int DEEPEST = 30;
constexpr long MOST_POINTS = 1'000'000;
// The two numbers of points that are compared.
constexpr int FEW = 8, MANY = 12;
// A direction in the parameter plane nearer to an axis than this lies along it.
constexpr double ALONG = 1e-15;
// The area of a sliver may come out below nothing by what tolerances leave, relative to the size.
constexpr double WRONG_WAY = 1e-6;

// A boundary curve in the parameter plane of a surface; on planes the curve in space, laid down: it
// is what the neighbours share, and planes often keep no other.
struct Border {
  const Ground& ground;
  std::optional<Geom2dAdaptor_Curve> flat;
  std::optional<BRepAdaptor_Curve> space;

  Border(const Ground& on, const Handle(Geom2d_Curve)& curve, double first, double last)
      : ground(on), flat(std::in_place, curve, first, last) {}
  Border(const Ground& on, const TopoDS_Edge& edge) : ground(on), space(std::in_place, edge) {}

  void at(double t, gp_XY& uv, double& du) const {
    if (flat) {
      gp_Pnt2d p;
      gp_Vec2d d;
      flat->D1(t, p, d);
      uv = p.XY();
      du = d.X();
      return;
    }
    gp_Pnt p;
    gp_Vec d;
    space->D1(t, p, d);
    const gp_XYZ up = p.XYZ() - ground.origin - ground.o;
    uv = gp_XY(up.Dot(ground.x), up.Dot(ground.y));
    du = d.XYZ().Dot(ground.x);
  }
  gp_XY at(double t) const {
    gp_XY uv;
    double du = 0.0;
    at(t, uv, du);
    return uv;
  }
  double first() const { return flat ? flat->FirstParameter() : space->FirstParameter(); }
  double last() const { return flat ? flat->LastParameter() : space->LastParameter(); }
  GeomAbs_CurveType type() const { return flat ? flat->GetType() : space->GetType(); }
  // Along which nothing changes: F du is nothing there.
  bool upright() const {
    return flat && type() == GeomAbs_Line && std::abs(flat->Line().Direction().X()) < ALONG;
  }

  // Where knots of the curve are and where it crosses knot lines of the surface, ends included.
  std::vector<double> breaks() const {
    const int n = flat ? flat->NbIntervals(GeomAbs_CN) : space->NbIntervals(GeomAbs_CN);
    TColStd_Array1OfReal values(1, n + 1);
    flat ? flat->Intervals(values, GeomAbs_CN) : space->Intervals(values, GeomAbs_CN);
    std::vector<double> out(values.begin(), values.end());
    if (!ground.us.empty() || !ground.vs.empty()) {
      // A straight line crosses each but once; of a curve, what runs over a line and back between
      // two samples is left to the halving.
      const int samples = type() == GeomAbs_Line ? 1 : 8;
      for (int i = 1; i <= n; ++i) {
        const double step = (values(i + 1) - values(i)) / samples;
        for (int k = 0; k < samples; ++k) {
          crossings(values(i) + k * step, values(i) + (k + 1) * step, out);
        }
      }
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  void crossings(double a, double b, std::vector<double>& out) const {
    const gp_XY at_a = at(a), at_b = at(b);
    for (const int axis : {1, 2}) {
      const double low = std::min(at_a.Coord(axis), at_b.Coord(axis));
      const double high = std::max(at_a.Coord(axis), at_b.Coord(axis));
      const std::vector<double>& lines = axis == 1 ? ground.us : ground.vs;
      auto line = std::upper_bound(lines.begin(), lines.end(), low);
      for (; line != lines.end() && *line < high; ++line) {
        double before = a, after = b;
        for (int i = 0; i < 60; ++i) {
          const double middle = 0.5 * (before + after);
          ((at(middle).Coord(axis) < *line) == (at_a.Coord(axis) < *line) ? before : after) = middle;
        }
        out.push_back(0.5 * (before + after));
      }
    }
  }
};

// The integral over one face, which is taken as if it were not reversed.
struct Over {
  Ground ground;
  const Sums& tolerance;
  Sums& unsettled;
  Sums sums{};
  double v0 = 0.0;

  Over(const TopoDS_Face& face, const gp_XYZ& origin, const Sums& still, Sums& left)
      : ground(face, origin), tolerance(still), unsettled(left) {
    bool bounded = false;
    for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      const TopAbs_Orientation side = edge.Orientation();
      // Others lie within the face.
      if (side == TopAbs_FORWARD || side == TopAbs_REVERSED) {
        const std::optional<Border> border = along(face, edge);
        if (border) {
          if (!bounded) {
            v0 = border->at(border->first()).Y();
          }
          whole(*border, side == TopAbs_FORWARD ? -1.0 : 1.0);
        }
        bounded = true;
      }
    }
    if (!bounded) {
      all();
    }
  }

  std::optional<Border> along(const TopoDS_Face& face, const TopoDS_Edge& edge) const {
    double first = 0.0, last = 0.0;
    if (ground.sort == Ground::FLAT) {
      if (BRep_Tool::Degenerated(edge)) {
        return std::nullopt;
      }
      TopLoc_Location place;
      if (!BRep_Tool::Curve(edge, place, first, last).IsNull()) {
        return Border(ground, edge);
      }
    }
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
    // BRepGProp takes such an edge for nothing, and what it gives for the face is wrong.
    if (curve.IsNull()) {
      throw Invalid("an edge of a face has no curve on the face");
    }
    return Border(ground, curve, first, last);
  }

  // The whole surface: all of its boundary counts for nothing but the side at the highest v.
  void all() {
    const BRepAdaptor_Surface& s = ground.surface;
    v0 = s.FirstVParameter();
    const Handle(Geom2d_Curve) top =
        new Geom2d_Line(gp_Pnt2d(0.0, s.LastVParameter()), gp_Dir2d(1.0, 0.0));
    whole(Border(ground, top, s.FirstUParameter(), s.LastUParameter()), 1.0);
  }

  void whole(const Border& border, double sign) {
    if (border.upright()) {
      return;
    }
    const double a = border.first(), b = border.last();
    const GeomAbs_CurveType type = border.type();
    const bool level = border.flat && type == GeomAbs_Line &&
                       std::abs(border.flat->Line().Direction().Y()) < ALONG;
    Sums found{};
    Division exact{0, 0};
    if (ground.sort == Ground::FLAT && type == GeomAbs_Line) {
      // Cubes, integrated once, over a straight line.
      exact = {1, 3};
    } else if (ground.sort == Ground::FLAT && (type == GeomAbs_Circle || type == GeomAbs_Ellipse)) {
      exact = waves(5.0, b - a);
    } else if (level && (ground.sort == Ground::LATHED || ground.sort == Ground::RINGED)) {
      exact = waves(4.0, b - a);
    }
    for (int i = 0; i < exact.parts; ++i) {
      const double step = (b - a) / exact.parts;
      stretch(border, a + i * step, a + (i + 1) * step, exact.points, 0, 1, found);
    }
    if (exact.parts == 0) {
      const std::vector<double> breaks = border.breaks();
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        settle(border, breaks[i], breaks[i + 1], 0, 1, found);
      }
    }
    add(found, sign, sums);
  }

  void settle(const Border& border, double a, double b, int depth, int parts, Sums& out) {
    Sums few{}, many{};
    stretch(border, a, b, FEW, FEW, parts, few);
    stretch(border, a, b, MANY, MANY, parts, many);
    if (still(few, many)) {
      add(many, 1.0, out);
      return;
    }
    if (depth == DEEPEST || ground.points > MOST_POINTS) {
      add(many, 1.0, out);
      for (std::size_t i = 0; i < COUNT; ++i) {
        unsettled[i] += std::abs(many[i] - few[i]);
      }
      return;
    }
    // Which of the two ways is too coarse: along the boundary, or across the face.
    bool along = true;
    if (ground.sort == Ground::FREE) {
      Sums mixed{};
      stretch(border, a, b, MANY, FEW, parts, mixed);
      const bool across = !still(mixed, many);
      along = !across || !still(few, mixed);
      parts *= across ? 2 : 1;
    }
    const double middle = along ? 0.5 * (a + b) : b;
    settle(border, a, middle, depth + 1, parts, out);
    if (along) {
      settle(border, middle, b, depth + 1, parts, out);
    }
  }

  bool still(const Sums& few, const Sums& many) const {
    for (std::size_t i = 0; i < COUNT; ++i) {
      // Written so that NaN fails too.
      if (!(std::abs(many[i] - few[i]) <= tolerance[i])) {
        return false;
      }
    }
    return true;
  }

  // Adds F du along a stretch of a boundary curve.
  void stretch(const Border& border, double a, double b, int along, int across, int parts,
               Sums& out) {
    const Rule& rule = gauss(along);
    const std::size_t n = rule.x.size();
    std::array<gp_XY, 32> at;
    std::array<double, 32> w{};
    double low = v0, high = v0;
    for (std::size_t i = 0; i < n; ++i) {
      double du = 0.0;
      border.at(0.5 * (a + b) + 0.5 * (b - a) * rule.x[i], at[i], du);
      w[i] = 0.5 * (b - a) * rule.w[i] * du * (at[i].Y() < v0 ? -1.0 : 1.0);
      low = std::min(low, at[i].Y());
      high = std::max(high, at[i].Y());
    }
    // Band by band between knot lines: the surface then prepares each of its pieces but once.
    const std::vector<double>& lines = ground.vs;
    auto line = std::upper_bound(lines.begin(), lines.end(), low);
    for (double from = low; from < high;) {
      const double to = line == lines.end() ? high : std::min(*line++, high);
      for (std::size_t i = 0; i < n; ++i) {
        const double c0 = std::max(from, std::min(v0, at[i].Y()));
        const double c1 = std::min(to, std::max(v0, at[i].Y()));
        if (c0 < c1) {
          ground.line(at[i].X(), c0, c1, w[i], across, parts, out);
        }
      }
      from = to;
    }
  }
};

gp_Pnt point(const gp_XYZ& origin, const Sums& sums, std::size_t moment, double mass) {
  return gp_Pnt(origin + gp_XYZ(sums[moment], sums[moment + 1], sums[moment + 2]) / mass);
}

}  // namespace

Integrals integrals(const TopoDS_Shape& shape) {
  Integrals out;
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  if (box.IsVoid()) {
    return out;
  }
  if (box.IsOpen()) {
    throw Invalid("a face has no end");
  }
  // From the middle: what is summed up is then no larger than it must be.
  const gp_XYZ origin = 0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ());
  const double size = std::sqrt(box.SquareExtent());
  Sums still{}, sums{}, unsettled{};
  for (std::size_t i = 0; i < COUNT; ++i) {
    still[i] = STILL * std::pow(size, POWERS[i]);
  }
  const bool solid = TopExp_Explorer(shape, TopAbs_SOLID).More();
  const auto weigh = [&](TopExp_Explorer it, bool encloses) {
    for (; it.More(); it.Next()) {
      const TopoDS_Face& face = TopoDS::Face(it.Current());
      const Sums found = Over(face, origin, still, unsettled).sums;
      // Holes count against it: less than nothing can only be an outline that is taken for a hole.
      if (found[AREA] < -WRONG_WAY * size * size) {
        throw Invalid("the outline of a face runs the wrong way round");
      }
      const TopAbs_Orientation side = face.Orientation();
      // A face that is neither lies within the solid.
      const double sign = !encloses                ? 0.0
                          : side == TopAbs_FORWARD  ? 1.0
                          : side == TopAbs_REVERSED ? -1.0
                                                    : 0.0;
      for (std::size_t i = 0; i < COUNT; ++i) {
        sums[i] += i < VOLUME ? found[i] : sign * found[i];
      }
    }
  };
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
    weigh(TopExp_Explorer(it.Current(), TopAbs_FACE), true);
  }
  weigh(TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID), !solid);

  // Written so that NaN fails too.
  if (!(unsettled[AREA] <= UNSETTLED * std::abs(sums[AREA])) ||
      (solid && !(unsettled[VOLUME] <= UNSETTLED * std::abs(sums[VOLUME])))) {
    throw Invalid("the area or the volume of a face does not settle");
  }
  out.area = sums[AREA];
  out.volume = sums[VOLUME];
  out.area_center = out.area != 0.0 ? point(origin, sums, AREA + 1, out.area) : gp_Pnt(origin);
  out.center = out.volume != 0.0 ? point(origin, sums, FIRST, out.volume) : out.area_center;
  const gp_XYZ c = out.center.XYZ() - origin;
  // Steiner's theorem, to the centre.
  const double v = out.volume;
  const double xx = sums[SECOND] - v * c.X() * c.X();
  const double yy = sums[SECOND + 1] - v * c.Y() * c.Y();
  const double zz = sums[SECOND + 2] - v * c.Z() * c.Z();
  const double xy = sums[SECOND + 3] - v * c.X() * c.Y();
  const double yz = sums[SECOND + 4] - v * c.Y() * c.Z();
  const double zx = sums[SECOND + 5] - v * c.Z() * c.X();
  out.inertia = gp_Mat(yy + zz, -xy, -zx, -xy, xx + zz, -yz, -zx, -yz, xx + yy);
  return out;
}

}  // namespace assemcad
