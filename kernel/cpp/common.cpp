#include "common.h"

#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <Message_Alert.hxx>
#include <Message_ListOfAlert.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <algorithm>
#include <cctype>
#include <vector>

namespace assemcad {

gp_Ax2 axes(const At& at) { return gp_Ax2(pnt(at.origin), dir(at.z), dir(at.x)); }

gp_Trsf trsf(const Pose& pose) {
  const auto& m = pose.rows;
  gp_Trsf t;
  t.SetValues(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11]);
  // The scale that comes of rounding would make a location that OCCT refuses.
  t.SetScaleFactor(1.0);
  return t;
}

SolidPtr wrap(const TopoDS_Shape& shape) {
  if (shape.IsNull()) {
    throw Invalid("no shape came out");
  }
  auto solid = std::make_unique<Solid>();
  solid->shape = shape;
  return solid;
}

const TopoDS_Shape& shape_of(const Solid& solid) {
  if (solid.shape.IsNull()) {
    throw Refused("the shape is empty");
  }
  return solid.shape;
}

TopoDS_Shape moved(const Solid& solid, const Pose& pose) {
  const gp_Trsf t = trsf(pose);
  return shape_of(solid).Moved(TopLoc_Location(t));
}

Bnd_Box tight_box(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
  if (box.IsVoid()) {
    throw Invalid("the shape has no extent");
  }
  box.SetGap(0.0);
  return box;
}

BoundsRaw raw_bounds(const Bnd_Box& box) {
  BoundsRaw out;
  out.min = xyz(box.CornerMin());
  out.max = xyz(box.CornerMax());
  return out;
}

std::uint32_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return static_cast<std::uint32_t>(map.Extent());
}

std::string words(std::string id) {
  const auto underscore = id.find('_');
  if (underscore != std::string::npos) {
    id = id.substr(underscore + 1);
  }
  if (id.rfind("Alert", 0) == 0) {
    id = id.substr(5);
  }
  std::string out;
  for (const char c : id) {
    if (std::isupper(static_cast<unsigned char>(c)) && !out.empty()) {
      out += ' ';
    }
    out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

namespace {

const char* status_name(BRepCheck_Status status) {
  switch (status) {
    case BRepCheck_InvalidPointOnCurve:
    case BRepCheck_InvalidPointOnCurveOnSurface:
    case BRepCheck_InvalidPointOnSurface:
      return "a corner lies off its edge or face";
    case BRepCheck_No3DCurve:
    case BRepCheck_Multiple3DCurve:
    case BRepCheck_Invalid3DCurve:
      return "an edge has no proper curve";
    case BRepCheck_NoCurveOnSurface:
    case BRepCheck_InvalidCurveOnSurface:
    case BRepCheck_InvalidCurveOnClosedSurface:
    case BRepCheck_InvalidSameRangeFlag:
    case BRepCheck_InvalidSameParameterFlag:
      return "an edge lies off its face";
    case BRepCheck_InvalidDegeneratedFlag:
      return "an edge has shrunk to a point";
    case BRepCheck_FreeEdge:
      return "an edge bounds only one face";
    case BRepCheck_InvalidMultiConnexity:
      return "more than two faces meet at an edge";
    case BRepCheck_InvalidRange:
      return "an edge has an empty range";
    case BRepCheck_EmptyWire:
    case BRepCheck_InvalidWire:
      return "an outline is broken";
    case BRepCheck_RedundantEdge:
    case BRepCheck_RedundantWire:
    case BRepCheck_RedundantFace:
      return "something occurs twice";
    case BRepCheck_SelfIntersectingWire:
      return "an outline crosses itself";
    case BRepCheck_NoSurface:
      return "a face has no surface";
    case BRepCheck_IntersectingWires:
      return "outlines of one face cross each other";
    case BRepCheck_InvalidImbricationOfWires:
      return "a hole lies outside the outer outline or inside another hole";
    case BRepCheck_EmptyShell:
      return "a shell is empty";
    case BRepCheck_InvalidImbricationOfShells:
      return "shells are wrongly nested";
    case BRepCheck_UnorientableShape:
    case BRepCheck_BadOrientation:
    case BRepCheck_BadOrientationOfSubshape:
      return "the sides of a face are mixed up";
    case BRepCheck_NotClosed:
      return "the boundary is not closed";
    case BRepCheck_NotConnected:
      return "the boundary is not connected";
    case BRepCheck_InvalidToleranceValue:
      return "a tolerance is out of range";
    case BRepCheck_EnclosedRegion:
      return "a region is enclosed";
    default:
      return "a check of the shape failed";
  }
}

void collect(const BRepCheck_ListOfStatus& list, std::vector<std::string>& found) {
  for (BRepCheck_ListOfStatus::Iterator it(list); it.More(); it.Next()) {
    if (it.Value() == BRepCheck_NoError) {
      continue;
    }
    const std::string reason = status_name(it.Value());
    if (std::find(found.begin(), found.end(), reason) == found.end()) {
      found.push_back(reason);
    }
  }
}

}  // namespace

rust::Vec<rust::String> reasons(const TopoDS_Shape& shape) {
  rust::Vec<rust::String> out;
  BRepCheck_Analyzer analyzer(shape, Standard_True);
  if (analyzer.IsValid()) {
    return out;
  }
  std::vector<std::string> found;
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, map);
  for (Standard_Integer i = 1; i <= map.Extent(); ++i) {
    const Handle(BRepCheck_Result)& result = analyzer.Result(map(i));
    if (result.IsNull()) {
      continue;
    }
    collect(result->Status(), found);
    for (result->InitContextIterator(); result->MoreShapeInContext();
         result->NextShapeInContext()) {
      collect(result->StatusOnShape(), found);
    }
  }
  if (found.empty()) {
    found.push_back("a check of the shape failed");
  }
  for (std::size_t i = 0; i < found.size() && i < 8; ++i) {
    out.push_back(found[i]);
  }
  return out;
}

std::string joined(const rust::Vec<rust::String>& list) {
  std::string out;
  for (const auto& entry : list) {
    if (!out.empty()) {
      out += "; ";
    }
    out += std::string(entry);
  }
  return out;
}

rust::Vec<rust::String> alerts(const Handle(Message_Report)& report, Message_Gravity gravity) {
  rust::Vec<rust::String> out;
  if (report.IsNull()) {
    return out;
  }
  // One alert may come once for every face; once is enough.
  std::vector<std::string> found;
  for (Message_ListOfAlert::Iterator it(report->GetAlerts(gravity)); it.More(); it.Next()) {
    const std::string text = words(it.Value()->DynamicType()->Name());
    if (std::find(found.begin(), found.end(), text) == found.end()) {
      found.push_back(text);
      out.push_back(text);
    }
  }
  return out;
}

}  // namespace assemcad
