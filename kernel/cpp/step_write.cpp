#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepData_ConfParameters.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>

#include <sstream>
#include <vector>

#include "common.h"

namespace assemcad {

namespace {

void name(const TDF_Label& label, rust::Str text) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(std::string(text).c_str(), Standard_True));
}

Handle(TCollection_HAsciiString) text(const rust::String& value) {
  return new TCollection_HAsciiString(std::string(value).c_str());
}

Handle(Interface_HArray1OfHAsciiString) texts(const rust::Vec<rust::String>& values) {
  const auto size = static_cast<Standard_Integer>(values.size());
  Handle(Interface_HArray1OfHAsciiString) out = new Interface_HArray1OfHAsciiString(1, size);
  for (Standard_Integer i = 1; i <= size; ++i) {
    out->SetValue(i, text(values[static_cast<std::size_t>(i) - 1]));
  }
  return out;
}

struct Painted {
  TopoDS_Shape shape;
  double red, green, blue;
};

// Styles the solids in the order of the parts. OCCT's own writer of colours goes through a map keyed
// by addresses, so that its order differs from process to process; and it takes colours through
// single precision and powers, so that 0.8 comes out as 0.800000010877.
void paint(const Handle(XSControl_WorkSession)& session, Handle(StepData_StepModel) model,
           const std::vector<Painted>& painted) {
  for (const Painted& part : painted) {
    STEPConstruct_Styles styles(session);
    const Handle(StepRepr_RepresentationItem) item =
        STEPConstruct::FindEntity(styles.FinderProcess(), part.shape);
    const Handle(StepRepr_RepresentationContext) context = styles.FindContext(part.shape);
    if (item.IsNull() || context.IsNull()) {
      throw Invalid("a solid could not be coloured");
    }
    Handle(StepVisual_ColourRgb) colour = new StepVisual_ColourRgb;
    colour->Init(new TCollection_HAsciiString(""), part.red, part.green, part.blue);
    styles.AddStyle(item, styles.MakeColorPSA(item, colour, colour, nullptr, 0.0), nullptr);
    Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) presentation;
    if (!styles.CreateMDGPR(context, presentation, model)) {
      throw Invalid("a colour could not be written");
    }
    model->AddWithRefs(presentation);
  }
}

}  // namespace

struct StepDoc::Inner {
  Handle(TDocStd_Document) document;
  Handle(XCAFDoc_ShapeTool) shapes;
  std::vector<TDF_Label> labels;
  std::vector<Painted> painted;

  const TDF_Label& label(std::uint32_t index) const {
    if (index >= labels.size()) {
      throw Refused("there is no product of this number");
    }
    return labels[index];
  }
};

StepDoc::StepDoc() : inner(std::make_unique<Inner>()) {
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", inner->document);
  if (inner->document.IsNull()) {
    throw Invalid("no document could be made");
  }
  XCAFDoc_DocumentTool::SetLengthUnit(inner->document, 1.0, UnitsMethods_LengthUnit_Millimeter);
  inner->shapes = XCAFDoc_DocumentTool::ShapeTool(inner->document->Main());
}

StepDoc::~StepDoc() {
  try {
    if (inner && !inner->document.IsNull()) {
      XCAFApp_Application::GetApplication()->Close(inner->document);
    }
  } catch (...) {
    // Nothing that a destructor could do better.
  }
}

std::uint32_t StepDoc::add_part(rust::Str part_name, const Solid& solid, Reals color) {
  const TDF_Label label = inner->shapes->NewShape();
  inner->shapes->SetShape(label, shape_of(solid));
  name(label, part_name);
  if (color.size() == 3) {
    inner->painted.push_back({shape_of(solid), color[0], color[1], color[2]});
  }
  inner->labels.push_back(label);
  return static_cast<std::uint32_t>(inner->labels.size() - 1);
}

std::uint32_t StepDoc::add_assembly(rust::Str assembly_name) {
  const TDF_Label label = inner->shapes->NewShape();
  name(label, assembly_name);
  inner->labels.push_back(label);
  return static_cast<std::uint32_t>(inner->labels.size() - 1);
}

void StepDoc::add_instance(std::uint32_t assembly, std::uint32_t of, rust::Str instance_name,
                           const Pose& pose) {
  const gp_Trsf t = trsf(pose);
  const TDF_Label component = inner->shapes->AddComponent(
      inner->label(assembly), inner->label(of), TopLoc_Location(t));
  if (component.IsNull()) {
    throw Invalid("an instance could not be added");
  }
  name(component, instance_name);
}

rust::Vec<std::uint8_t> StepDoc::write(const HeaderRaw& header) {
  inner->shapes->UpdateAssemblies();
  // Read when the writer makes its model: set later, the first file gets another schema.
  STEPCAFControl_Controller::Init();
  Interface_Static::SetCVal("write.step.schema", "AP242DIS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.product.name", std::string(header.name).c_str());

  STEPCAFControl_Writer writer;
  writer.SetColorMode(Standard_False);
  writer.SetNameMode(Standard_True);
  writer.SetLayerMode(Standard_False);
  writer.SetPropsMode(Standard_False);
  StepData_ConfParameters parameters;
  parameters.InitFromStatic();
  parameters.WriteSchema = StepData_ConfParameters::WriteMode_StepSchema_AP242DIS;
  parameters.WriteAssembly = StepData_ConfParameters::WriteMode_Assembly_On;
  parameters.WriteUnit = UnitsMethods_LengthUnit_Millimeter;
  if (!writer.Transfer(inner->document, parameters, STEPControl_AsIs)) {
    throw Invalid("the assembly could not be translated");
  }

  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  paint(writer.ChangeWriter().WS(), model, inner->painted);
  APIHeaderSection_MakeHeader fields(model);
  fields.SetName(text(header.name));
  fields.SetTimeStamp(text(header.time_stamp));
  fields.SetAuthor(texts(header.author));
  fields.SetOrganization(texts(header.organization));
  fields.SetPreprocessorVersion(text(header.preprocessor));
  fields.SetOriginatingSystem(text(header.originating_system));
  fields.SetAuthorisation(text(header.authorisation));
  fields.SetDescription(texts(header.description));

  std::ostringstream stream(std::ios::binary);
  if (writer.WriteStream(stream) != IFSelect_RetDone || !stream.good()) {
    throw Invalid("the file could not be written");
  }
  const std::string bytes = stream.str();
  rust::Vec<std::uint8_t> out;
  out.reserve(bytes.size());
  for (const char c : bytes) {
    out.push_back(static_cast<std::uint8_t>(c));
  }
  return out;
}

StepDocPtr step_doc() { return std::make_unique<StepDoc>(); }

}  // namespace assemcad
