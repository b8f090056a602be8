#include <BRepBuilderAPI_MakeEdge.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeArcOfEllipse.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_HArray1OfBoolean.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfVec.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include "brep_common.h"

namespace assemcad {

namespace {

SolidPtr edge_from(BRepBuilderAPI_MakeEdge&& maker) {
  if (!maker.IsDone()) {
    throw Refused("its ends do not fit its curve");
  }
  return wrap(maker.Edge());
}

// Points as the array that OCCT's builders take; `flat` has three numbers for each.
Handle(TColgp_HArray1OfPnt) points_in(Reals flat) {
  const auto size = static_cast<Standard_Integer>(flat.size() / 3);
  if (size < 2) {
    throw Refused("it takes at least two points");
  }
  Handle(TColgp_HArray1OfPnt) out = new TColgp_HArray1OfPnt(1, size);
  for (Standard_Integer i = 0; i < size; ++i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    out->SetValue(i + 1, gp_Pnt(flat[at], flat[at + 1], flat[at + 2]));
  }
  return out;
}

gp_Vec vector_in(Reals flat, std::size_t index) {
  return gp_Vec(flat[3 * index], flat[3 * index + 1], flat[3 * index + 2]);
}

// The major axis of an ellipse of OCCT is its x axis: one that is taller than wide is turned.
gp_Elips ellipse_in(const At& at, double x_radius, double y_radius) {
  const gp_Ax2 frame = axes(at);
  if (y_radius > x_radius) {
    return gp_Elips(frame, y_radius, x_radius).Rotated(frame.Axis(), M_PI / 2.0);
  }
  return gp_Elips(frame, x_radius, y_radius);
}

}  // namespace

SolidPtr edge_line(const Vector& from, const Vector& to) {
  return edge_from(BRepBuilderAPI_MakeEdge(pnt(from), pnt(to)));
}

SolidPtr edge_arc(const Vector& from, const Vector& via, const Vector& to) {
  const GC_MakeArcOfCircle arc(pnt(from), pnt(via), pnt(to));
  if (!arc.IsDone()) {
    throw Refused("its three points lie on one line");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(arc.Value()));
}

SolidPtr edge_tangent_arc(const Vector& from, const Vector& tangent, const Vector& to) {
  const GC_MakeArcOfCircle arc(pnt(from), gp_Vec(tangent[0], tangent[1], tangent[2]), pnt(to));
  if (!arc.IsDone()) {
    throw Refused("its end lies straight ahead of its start: that is a line");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(arc.Value()));
}

SolidPtr edge_circle(const At& at, double radius) {
  return edge_from(BRepBuilderAPI_MakeEdge(gp_Circ(axes(at), radius)));
}

SolidPtr edge_circle_arc(const At& at, double radius, double from, double to) {
  const GC_MakeArcOfCircle arc(gp_Circ(axes(at), radius), from, to, Standard_True);
  if (!arc.IsDone()) {
    throw Refused("there is no such arc");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(arc.Value()));
}

SolidPtr edge_ellipse(const At& at, double x_radius, double y_radius, double rotation) {
  gp_Elips ellipse = ellipse_in(at, x_radius, y_radius);
  if (rotation != 0.0) {
    ellipse.Rotate(axes(at).Axis(), rotation);
  }
  return edge_from(BRepBuilderAPI_MakeEdge(ellipse));
}

SolidPtr edge_ellipse_arc(const At& at, double x_radius, double y_radius, double from, double to,
                          bool forward) {
  const double turned = y_radius > x_radius ? M_PI / 2.0 : 0.0;
  const GC_MakeArcOfEllipse arc(ellipse_in(at, x_radius, y_radius), from - turned, to - turned,
                                forward);
  if (!arc.IsDone()) {
    throw Refused("there is no such arc");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(arc.Value()));
}

// Tangents: none, two (at the ends) or one for each point, of which only those flagged count.
SolidPtr edge_spline(Reals points, Reals tangents, Flags given, Reals parameters, bool periodic,
                     bool scale, double tolerance) {
  const Handle(TColgp_HArray1OfPnt) through = points_in(points);
  Handle(TColStd_HArray1OfReal) at;
  if (parameters.size() > 0) {
    const auto size = static_cast<Standard_Integer>(parameters.size());
    at = new TColStd_HArray1OfReal(1, size);
    for (Standard_Integer i = 0; i < size; ++i) {
      at->SetValue(i + 1, parameters[static_cast<std::size_t>(i)]);
    }
  }
  GeomAPI_Interpolate maker = at.IsNull()
                                  ? GeomAPI_Interpolate(through, periodic, tolerance)
                                  : GeomAPI_Interpolate(through, at, periodic, tolerance);
  if (given.size() == 2 && through->Length() != 2) {
    maker.Load(vector_in(tangents, 0), vector_in(tangents, 1), scale);
  } else if (given.size() > 0) {
    TColgp_Array1OfVec directions(1, through->Length());
    Handle(TColStd_HArray1OfBoolean) counts = new TColStd_HArray1OfBoolean(1, through->Length());
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto index = static_cast<Standard_Integer>(i) + 1;
      directions.SetValue(index, vector_in(tangents, i));
      counts->SetValue(index, given[i]);
    }
    maker.Load(directions, counts, scale);
  }
  maker.Perform();
  if (!maker.IsDone()) {
    throw Invalid("no curve runs through its points like that");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(maker.Curve()));
}

SolidPtr edge_spline_approx(Reals points, double tolerance, std::uint32_t min_degree,
                            std::uint32_t max_degree) {
  const GeomAPI_PointsToBSpline maker(
      points_in(points)->Array1(), static_cast<Standard_Integer>(min_degree),
      static_cast<Standard_Integer>(max_degree), GeomAbs_C2, tolerance);
  if (!maker.IsDone()) {
    throw Invalid("no curve of these degrees comes near enough to its points");
  }
  return edge_from(BRepBuilderAPI_MakeEdge(maker.Curve()));
}

SolidPtr edge_bezier(Reals points) {
  const Handle(TColgp_HArray1OfPnt) poles = points_in(points);
  if (poles->Length() > Geom_BezierCurve::MaxDegree() + 1) {
    throw Refused("it takes at most 26 points");
  }
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles->Array1());
  return edge_from(BRepBuilderAPI_MakeEdge(curve));
}

}  // namespace assemcad
