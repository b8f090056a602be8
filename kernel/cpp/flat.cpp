#include "flat.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>

#include <algorithm>
#include <cmath>

#include "shim.h"

namespace assemcad {

namespace {

// Nearer to an edge than this, in mm, nobody knows on which side a point is.
constexpr double CLOSE = 1e-6;
// The plane of a circle may be turned by this against the face's.
constexpr double TURNED = 1e-9;
// Into how many straight pieces a stretch of a curve without knots is divided, and by how much more than
// was seen it may be off.
constexpr int PIECES = 16;
constexpr double UNSEEN = 4.0;

}  // namespace

Flat::Flat(const TopoDS_Face& face, const gp_Ax3& plane) {
  const gp_XYZ o = plane.Location().XYZ();
  const gp_XYZ x = plane.XDirection().XYZ(), y = plane.YDirection().XYZ();
  const auto down = [&](const gp_Pnt& p) {
    const gp_XYZ w = p.XYZ() - o;
    return gp_XY(w.Dot(x), w.Dot(y));
  };
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) {
      throw Invalid("a plane face has an edge that bounds nothing");
    }
    if (BRep_Tool::Degenerated(edge)) {
      continue;
    }
    const double off = std::max(CLOSE, BRep_Tool::Tolerance(edge));
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    if (curve.GetType() == GeomAbs_Line) {
      straight(down(curve.Value(first)), down(curve.Value(last)), off);
      continue;
    }
    if (curve.GetType() == GeomAbs_Circle) {
      const gp_Circ circle = curve.Circle();
      const gp_XYZ axis = circle.Axis().Direction().XYZ();
      const double up = axis.Dot(plane.Direction().XYZ());
      if (std::abs(up) > 1.0 - TURNED) {
        const gp_XY centre = down(circle.Location()), start = down(curve.Value(first)) - centre;
        // The plane's own x and y may be left-handed.
        const double turn = x.Crossed(y).Dot(axis) > 0.0 ? last - first : first - last;
        arc(centre, circle.Radius(), std::atan2(start.Y(), start.X()), turn, off);
        continue;
      }
    }
    const int n = curve.NbIntervals(GeomAbs_C2);
    TColStd_Array1OfReal knots(1, n + 1);
    curve.Intervals(knots, GeomAbs_C2);
    for (int i = 1; i <= n; ++i) {
      const double step = (knots(i + 1) - knots(i)) / PIECES;
      gp_XY from = down(curve.Value(knots(i)));
      for (int k = 0; k < PIECES; ++k) {
        const double t = knots(i) + k * step;
        const gp_XY to = down(curve.Value(k + 1 == PIECES ? knots(i + 1) : t + step));
        const gp_XY bulge = down(curve.Value(t + 0.5 * step)) - 0.5 * (from + to);
        straight(from, to, off + UNSEEN * bulge.Modulus());
        from = to;
      }
    }
  }
}

void Flat::straight(const gp_XY& from, const gp_XY& to, double off) {
  pieces.push_back({from, to, gp_XY(), 0.0, 0.0, off});
}

void Flat::arc(const gp_XY& centre, double radius, double from, double turn, double off) {
  const auto at = [&](double angle) {
    return centre + radius * gp_XY(std::cos(angle), std::sin(angle));
  };
  // Cut where the circle turns from going up to going down: at a quarter turn up and down.
  const double low = std::min(from, from + turn), high = std::max(from, from + turn);
  std::vector<double> cuts{low};
  for (double k = std::ceil((low - M_PI_2) / M_PI); M_PI_2 + k * M_PI < high; k += 1.0) {
    if (M_PI_2 + k * M_PI > low) {
      cuts.push_back(M_PI_2 + k * M_PI);
    }
  }
  cuts.push_back(high);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    pieces.push_back({at(cuts[i]), at(cuts[i + 1]), centre, radius,
                      std::cos(middle) > 0.0 ? 1.0 : -1.0, off});
  }
}

Within Flat::holds(const gp_XY& at) const {
  bool in = false;
  for (const Piece& piece : pieces) {
    const double low = std::min(piece.from.Y(), piece.to.Y()) - piece.off;
    const double high = std::max(piece.from.Y(), piece.to.Y()) + piece.off;
    if (at.Y() < low || at.Y() > high) {
      continue;
    }
    // Where the half line passes, towards +x.
    double x = 0.0;
    if (piece.radius > 0.0) {
      const double up = at.Y() - piece.centre.Y();
      const double square = piece.radius * piece.radius - up * up;
      x = piece.centre.X() + piece.side * std::sqrt(std::max(square, 0.0));
    } else {
      const double height = piece.to.Y() - piece.from.Y();
      const double rest = std::abs(height) > 0.0 ? (at.Y() - piece.from.Y()) / height : 0.0;
      x = piece.from.X() + std::clamp(rest, 0.0, 1.0) * (piece.to.X() - piece.from.X());
    }
    const double right = std::max({piece.from.X(), piece.to.X(), x});
    if (at.X() > right + piece.off) {
      continue;
    }
    // At an end the neighbours may not agree on who is crossed.
    if (at.Y() < low + 2.0 * piece.off || at.Y() > high - 2.0 * piece.off) {
      return Within::UNSURE;
    }
    if (std::abs(x - at.X()) <= piece.off && piece.off <= CLOSE) {
      return Within::UNSURE;
    }
    if (piece.off > CLOSE && clear(at) <= 0.0) {
      return Within::UNSURE;
    }
    in = in != (x > at.X());
  }
  return in ? Within::YES : Within::NO;
}

double Flat::clear(const gp_XY& at) const {
  double nearest = RealLast();
  for (const Piece& piece : pieces) {
    double gap = std::min((at - piece.from).Modulus(), (at - piece.to).Modulus());
    if (piece.radius > 0.0) {
      const gp_XY arm = at - piece.centre;
      const double low = std::min(piece.from.Y(), piece.to.Y()), high = std::max(piece.from.Y(), piece.to.Y());
      const double foot = arm.Modulus() > 0.0 ? arm.Y() / arm.Modulus() * piece.radius + piece.centre.Y() : low;
      if (arm.X() * piece.side >= 0.0 && foot >= low && foot <= high) {
        gap = std::min(gap, std::abs(arm.Modulus() - piece.radius));
      }
    } else {
      const gp_XY way = piece.to - piece.from;
      const double square = way.SquareModulus();
      if (square > 0.0) {
        const double share = std::clamp((at - piece.from).Dot(way) / square, 0.0, 1.0);
        gap = std::min(gap, (at - piece.from - share * way).Modulus());
      }
    }
    nearest = std::min(nearest, gap - piece.off);
  }
  return nearest;
}

}  // namespace assemcad
