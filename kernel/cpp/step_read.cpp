#include <STEPCAFControl_Reader.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <sstream>
#include <vector>

#include "common.h"
#include "integrals.h"

namespace assemcad {

namespace {

// A file may nest products without end only by referring to itself, which is no assembly.
constexpr std::size_t DEEPEST = 64;

std::string name(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) {
    return {};
  }
  return TCollection_AsciiString(attribute->Get()).ToCString();
}

struct Measured {
  TopoDS_Shape shape;
  Integrals found;
  BoundsRaw bounds;
  std::uint32_t solids;
};

struct Walk {
  std::vector<Measured> measured;
  rust::Vec<LeafRaw> leaves;
  std::vector<std::string> path;

  void leaf(const TDF_Label& product, const TopLoc_Location& location) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    if (shape.IsNull()) {
      throw Refused("a product of the file has no shape");
    }
    // The products of an assembly are few, and their instances many: each is measured once, in its own frame.
    std::size_t index = 0;
    while (index < measured.size() && !measured[index].shape.IsSame(shape)) {
      ++index;
    }
    if (index == measured.size()) {
      measured.push_back({shape, integrals(shape), raw_bounds(tight_box(shape)),
                          count(shape, TopAbs_SOLID)});
    }
    const Measured& own = measured[index];
    const gp_Trsf at = location.Transformation();
    LeafRaw out;
    for (const std::string& step : path) {
      out.path.push_back(step);
    }
    out.product = name(product);
    out.volume = own.found.volume;
    out.own_center = xyz(own.found.center);
    out.center = xyz(own.found.center.Transformed(at));
    out.bounds = own.bounds;
    out.solids = own.solids;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        out.inertia[3 * row + column] = own.found.inertia(row + 1, column + 1) + 0.0;
      }
      for (int column = 0; column < 4; ++column) {
        out.pose.rows[4 * row + column] = at.Value(row + 1, column + 1) + 0.0;
      }
    }
    leaves.push_back(std::move(out));
  }

  void product(const TDF_Label& label, const TopLoc_Location& location) {
    if (path.size() > DEEPEST) {
      throw Refused("the file nests its products too deeply");
    }
    if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
      leaf(label, location);
      return;
    }
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (Standard_Integer i = 1; i <= components.Length(); ++i) {
      const TDF_Label& component = components.Value(i);
      TDF_Label referred;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, referred)) {
        throw Refused("an instance of the file refers to no product");
      }
      path.push_back(name(component));
      product(referred, location * XCAFDoc_ShapeTool::GetLocation(component));
      path.pop_back();
    }
  }
};

struct Document {
  Handle(TDocStd_Document) handle;
  Document() {
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", handle);
    if (handle.IsNull()) {
      throw Invalid("no document could be made");
    }
    XCAFDoc_DocumentTool::SetLengthUnit(handle, 1.0, UnitsMethods_LengthUnit_Millimeter);
  }
  ~Document() {
    try {
      XCAFApp_Application::GetApplication()->Close(handle);
    } catch (...) {
      // Nothing that a destructor could do better.
    }
  }
};

}  // namespace

rust::Vec<LeafRaw> read_step(Bytes bytes) {
  std::istringstream stream(
      std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), std::ios::binary);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  if (reader.ReadStream("input.step", stream) != IFSelect_RetDone) {
    throw Refused("the bytes are no STEP file");
  }
  const Document document;
  if (!reader.Transfer(document.handle)) {
    throw Refused("nothing of the STEP file could be translated");
  }
  const Handle(XCAFDoc_ShapeTool) shapes =
      XCAFDoc_DocumentTool::ShapeTool(document.handle->Main());
  TDF_LabelSequence roots;
  shapes->GetFreeShapes(roots);
  Walk walk;
  for (Standard_Integer i = 1; i <= roots.Length(); ++i) {
    const TDF_Label& root = roots.Value(i);
    walk.path.push_back(name(root));
    walk.product(root, XCAFDoc_ShapeTool::GetLocation(root));
    walk.path.pop_back();
  }
  return std::move(walk.leaves);
}

}  // namespace assemcad
