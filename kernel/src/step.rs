//! STEP: writing a tree of products, and reading one back to check it.

use assemcad_model::frame::{Placement, Rows};
use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::limits::coordinates;
use crate::query::Bounds;
use crate::shape::{Shape, pose, start};

/// The time stamp of every file: a file made twice has the same bytes.
pub const TIME_STAMP: &str = "1970-01-01T00:00:00";

/// A part: one product with a solid, however often it is used.
#[derive(Debug)]
pub struct Part<'a> {
    /// Name of the product.
    pub name: &'a str,
    /// Its solid, in the part's frame.
    pub shape: &'a Shape,
    /// sRGB colour, each from 0 to 1.
    pub color: Option<[f64; 3]>,
}

/// An assembly: one product made of instances.
#[derive(Debug)]
pub struct Assembly<'a> {
    /// Name of the product.
    pub name: &'a str,
    /// What it is made of.
    pub instances: Vec<Instance<'a>>,
}

/// One use of a product in an assembly.
#[derive(Debug)]
pub struct Instance<'a> {
    /// Name of this use.
    pub name: &'a str,
    /// The product.
    pub of: Product,
    /// Where it is, in the assembly's frame.
    pub placement: Placement,
}

/// A product of a [`Tree`], by position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// A position in [`Tree::parts`].
    Part(usize),
    /// A position in [`Tree::assemblies`].
    Assembly(usize),
}

/// The products of a file. The last assembly is the root; each refers only to earlier ones, and
/// every product is used.
#[derive(Debug, Default)]
pub struct Tree<'a> {
    /// The parts.
    pub parts: Vec<Part<'a>>,
    /// The assemblies.
    pub assemblies: Vec<Assembly<'a>>,
}

/// The header of a file. The time stamp is always [`TIME_STAMP`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Header {
    /// Name of the file.
    pub file_name: String,
    /// What the file holds, line by line.
    pub description: Vec<String>,
    /// Who made it.
    pub author: Vec<String>,
    /// For whom.
    pub organization: Vec<String>,
    /// The program that wrote the file.
    pub preprocessor: String,
    /// The program that the data come from.
    pub originating_system: String,
    /// Who answers for it.
    pub authorisation: String,
}

/// One solid of a file, placed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Leaf {
    /// Names from the root's product down to the instance.
    pub path: Vec<String>,
    /// Name of the product.
    pub product: String,
    /// How many solids it is made of.
    pub solids: u32,
    /// Volume in mm3.
    pub volume: f64,
    /// Centre of the volume, in the root's frame.
    pub center: [f64; 3],
    /// The same in the product's own frame.
    pub own_center: [f64; 3],
    /// Matrix of inertia about the centre, along the axes of the product's own frame, in mm5.
    pub inertia: [[f64; 3]; 3],
    /// Tight box in the product's own frame.
    pub bounds: Bounds,
    /// Where the product's frame is, in the root's.
    pub placement: Rows,
}

/// A tree as a STEP file: AP242, millimetres, one product for each part and assembly.
///
/// The numbers that identify the uses of products count on through the life of the process: for the
/// same bytes, write each file first thing in a fresh one.
///
/// # Errors
/// When the tree is none, a text cannot be written, or the kernel fails.
pub fn write(tree: &Tree<'_>, header: &Header) -> Result<Vec<u8>> {
    start()?;
    sound(tree)?;
    let fields = fields(header)?;
    let failed = || "the STEP file could not be made".to_owned();
    let mut doc = bridge::step_doc().context(failed)?;

    let mut parts = Vec::new();
    for part in &tree.parts {
        writable("name of a part", part.name)?;
        let color = part.color.unwrap_or_default();
        if color.iter().any(|c| !(0.0..=1.0).contains(c)) {
            return Err(KernelError::refused(format!(
                "the colour of part {} must be three numbers from 0 to 1",
                part.name
            )));
        }
        let color: &[f64] = if part.color.is_some() { &color } else { &[] };
        let label = doc
            .pin_mut()
            .add_part(part.name, part.shape.solid()?, color)
            .context(failed)?;
        parts.push(label);
    }
    let mut assemblies: Vec<u32> = Vec::new();
    for assembly in &tree.assemblies {
        writable("name of an assembly", assembly.name)?;
        let label = doc.pin_mut().add_assembly(assembly.name).context(failed)?;
        for instance in &assembly.instances {
            writable("name of an instance", instance.name)?;
            coordinates("placement", instance.placement.origin().as_slice())?;
            let of = match instance.of {
                Product::Part(index) => parts.get(index),
                Product::Assembly(index) => assemblies.get(index),
            }
            .copied()
            .ok_or_else(|| unknown(assembly.name, instance.name))?;
            let pose = pose(&instance.placement)?;
            doc.pin_mut()
                .add_instance(label, of, instance.name, &pose)
                .context(failed)?;
        }
        assemblies.push(label);
    }
    doc.pin_mut().write(&fields).context(failed)
}

/// The solids of a STEP file, in the order of its instances; lengths are brought to mm.
///
/// # Errors
/// When the bytes are no STEP file or hold nothing that can be read.
pub fn read(bytes: &[u8]) -> Result<Vec<Leaf>> {
    start()?;
    let leaves =
        bridge::read_step(bytes).context(|| "the STEP file could not be read".to_owned())?;
    Ok(leaves
        .into_iter()
        .map(|leaf| Leaf {
            path: leaf.path,
            product: leaf.product,
            solids: leaf.solids,
            volume: leaf.volume,
            center: leaf.center,
            own_center: leaf.own_center,
            inertia: matrix(leaf.inertia),
            bounds: leaf.bounds.into(),
            placement: Rows(rows(leaf.pose.rows)),
        })
        .collect())
}

fn matrix([a, b, c, d, e, f, g, h, i]: [f64; 9]) -> [[f64; 3]; 3] {
    [[a, b, c], [d, e, f], [g, h, i]]
}

fn rows([a, b, c, d, e, f, g, h, i, j, k, l]: [f64; 12]) -> [[f64; 4]; 3] {
    [[a, b, c, d], [e, f, g, h], [i, j, k, l]]
}

fn unknown(assembly: &str, instance: &str) -> KernelError {
    KernelError::refused(format!(
        "instance {instance} of assembly {assembly} refers to no earlier product"
    ))
}

/// That there is a root and that no product is left over: it would be a second root.
fn sound(tree: &Tree<'_>) -> Result<()> {
    let Some((_, below)) = tree.assemblies.split_last() else {
        return Err(KernelError::refused("the STEP file needs a root assembly"));
    };
    for assembly in &tree.assemblies {
        if assembly.instances.is_empty() {
            return Err(KernelError::refused(format!(
                "assembly {} is empty",
                assembly.name
            )));
        }
    }
    let used = |product: Product| {
        tree.assemblies
            .iter()
            .any(|a| a.instances.iter().any(|i| i.of == product))
    };
    let parts = tree
        .parts
        .iter()
        .enumerate()
        .map(|(i, p)| (Product::Part(i), p.name));
    let assemblies = below
        .iter()
        .enumerate()
        .map(|(i, a)| (Product::Assembly(i), a.name));
    for (product, name) in parts.chain(assemblies) {
        if !used(product) {
            return Err(KernelError::refused(format!("product {name} is not used")));
        }
    }
    Ok(())
}

/// STEP text is printable ASCII; anything else would need an encoding that few readers know.
fn writable(what: &str, text: &str) -> Result<()> {
    if text.is_empty() {
        return Err(KernelError::refused(format!("the {what} is empty")));
    }
    if let Some(bad) = text.chars().find(|c| !matches!(c, ' '..='~')) {
        return Err(KernelError::refused(format!(
            "the {what} holds the character {bad:?}; STEP files take printable ASCII only"
        )));
    }
    Ok(())
}

fn fields(header: &Header) -> Result<bridge::HeaderRaw> {
    let lists = [
        ("description of the file", &header.description),
        ("author of the file", &header.author),
        ("organisation of the file", &header.organization),
    ];
    for (what, list) in lists {
        if list.is_empty() {
            return Err(KernelError::refused(format!("the {what} is missing")));
        }
        for line in list {
            writable(what, line)?;
        }
    }
    writable("name of the file", &header.file_name)?;
    writable("preprocessor of the file", &header.preprocessor)?;
    writable("originating system of the file", &header.originating_system)?;
    writable("authorisation of the file", &header.authorisation)?;
    Ok(bridge::HeaderRaw {
        name: header.file_name.clone(),
        time_stamp: TIME_STAMP.to_owned(),
        description: header.description.clone(),
        author: header.author.clone(),
        organization: header.organization.clone(),
        preprocessor: header.preprocessor.clone(),
        originating_system: header.originating_system.clone(),
        authorisation: header.authorisation.clone(),
    })
}
