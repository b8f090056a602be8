//! The arguments of a call, read with their types.
//!
//! The front end has checked them; a recipe may still come from anywhere, so that nothing is trusted.

use std::rc::Rc;

use assemcad_model::frame::{Frame, Placement};
use assemcad_model::recipe::{Call, Ref, reference};
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::value::{Node, Object, Value, Vector};
use crate::error::{KernelError, Result};
use crate::limits::LARGEST;

/// A call and the results of those before it.
pub(super) struct Args<'a> {
    pub(super) call: &'a Call,
    pub(super) values: &'a [Value],
}

impl<'a> Args<'a> {
    fn wrong(&self, name: &str, what: &str) -> KernelError {
        KernelError::refused(format!("{name} of {} is {what}", self.call.call))
    }

    pub(super) fn json(&self, name: &str) -> Option<&'a Json> {
        self.call.args.get(name)
    }

    pub(super) fn given(&self, name: &str) -> bool {
        self.json(name).is_some()
    }

    pub(super) fn value(&self, at: Ref) -> Result<&'a Value> {
        usize::try_from(at)
            .ok()
            .and_then(|i| self.values.get(i))
            .ok_or_else(|| KernelError::refused("a call refers to one that is not before it"))
    }

    /// What the method is called on, where it is a workplane.
    pub(super) fn on(&self) -> Result<Rc<Node>> {
        match self.call.on.map(|on| self.value(on)).transpose()? {
            Some(Value::Node(node)) => Ok(Rc::clone(node)),
            _ => Err(self.wrong("what it is called on", "a workplane")),
        }
    }

    /// What the method is called on, where it is a shape.
    pub(super) fn on_object(&self) -> Result<Object> {
        match self.call.on.map(|on| self.value(on)).transpose()? {
            Some(Value::Object(object)) => Ok(object.clone()),
            _ => Err(self.wrong("what it is called on", "a shape")),
        }
    }

    pub(super) fn real(&self, name: &str) -> Result<f64> {
        self.real_or_none(name)?
            .ok_or_else(|| self.wrong(name, "a number"))
    }

    pub(super) fn real_or_none(&self, name: &str) -> Result<Option<f64>> {
        self.json(name)
            .map(|json| number(json).ok_or_else(|| self.wrong(name, "a number")))
            .transpose()
    }

    /// A length over 0.
    pub(super) fn length(&self, name: &str) -> Result<f64> {
        let length = self.real(name)?;
        crate::limits::length(&format!("{name} of {}", self.call.call), length)?;
        Ok(length)
    }

    pub(super) fn count(&self, name: &str) -> Result<i32> {
        self.json(name)
            .and_then(Json::as_i64)
            .and_then(|n| i32::try_from(n).ok())
            .ok_or_else(|| self.wrong(name, "a whole number"))
    }

    pub(super) fn flag(&self, name: &str) -> Result<bool> {
        self.json(name)
            .and_then(Json::as_bool)
            .ok_or_else(|| self.wrong(name, "True or False"))
    }

    pub(super) fn text(&self, name: &str) -> Result<&'a str> {
        self.text_or_none(name)?
            .ok_or_else(|| self.wrong(name, "a text"))
    }

    pub(super) fn text_or_none(&self, name: &str) -> Result<Option<&'a str>> {
        self.json(name)
            .map(|json| json.as_str().ok_or_else(|| self.wrong(name, "a text")))
            .transpose()
    }

    pub(super) fn vector(&self, name: &str) -> Result<Vector> {
        self.vector_or_none(name)?
            .ok_or_else(|| self.wrong(name, "a point of three numbers"))
    }

    pub(super) fn vector_or_none(&self, name: &str) -> Result<Option<Vector>> {
        self.json(name)
            .map(|json| vector(json).ok_or_else(|| self.wrong(name, "a point of three numbers")))
            .transpose()
    }

    pub(super) fn vectors(&self, name: &str) -> Result<Vec<Vector>> {
        self.json(name)
            .and_then(Json::as_array)
            .and_then(|items| items.iter().map(vector).collect())
            .ok_or_else(|| self.wrong(name, "a list of points"))
    }

    /// True or False for each of `N` directions; one for all of them.
    pub(super) fn flags<const N: usize>(&self, name: &str) -> Result<[bool; N]> {
        let flags = match self.json(name) {
            Some(Json::Bool(all)) => Some([*all; N]),
            Some(Json::Array(items)) => items
                .iter()
                .map(Json::as_bool)
                .collect::<Option<Vec<bool>>>()
                .and_then(|flags| flags.try_into().ok()),
            _ => None,
        };
        flags.ok_or_else(|| self.wrong(name, "True, False or one of them for each direction"))
    }

    /// Anything that serde reads.
    pub(super) fn read<T: DeserializeOwned>(&self, name: &str) -> Result<Option<T>> {
        self.json(name)
            .map(|json| {
                serde_json::from_value(json.clone())
                    .map_err(|_| self.wrong(name, "not what this call takes"))
            })
            .transpose()
    }

    /// The call that an argument refers to.
    pub(super) fn reference(&self, name: &str) -> Option<Ref> {
        self.json(name).and_then(reference)
    }

    pub(super) fn node(&self, name: &str) -> Result<Option<Rc<Node>>> {
        match self.reference(name).map(|at| self.value(at)).transpose()? {
            Some(Value::Node(node)) => Ok(Some(Rc::clone(node))),
            _ => Ok(None),
        }
    }

    /// The objects that an argument names: those of a workplane's stack, a shape, a list of them.
    pub(super) fn objects(&self, name: &str) -> Result<Vec<Object>> {
        let json = self.json(name).ok_or_else(|| self.wrong(name, "missing"))?;
        self.objects_of(name, json)
    }

    fn objects_of(&self, name: &str, json: &Json) -> Result<Vec<Object>> {
        if let Json::Array(items) = json {
            let mut all = Vec::new();
            for item in items {
                // Lists in lists are not written by the front end.
                let Some(at) = reference(item) else {
                    return Err(self.wrong(name, "a list of shapes"));
                };
                all.extend(self.objects_at(name, at)?);
            }
            return Ok(all);
        }
        let Some(at) = reference(json) else {
            return Err(self.wrong(name, "a workplane or shape"));
        };
        self.objects_at(name, at)
    }

    fn objects_at(&self, name: &str, at: Ref) -> Result<Vec<Object>> {
        match self.value(at)? {
            Value::Node(node) => Ok(node.objects.clone()),
            Value::Object(object) => Ok(vec![object.clone()]),
            Value::Objects(objects) => Ok(objects.clone()),
            Value::Place(_) | Value::Later => Err(self.wrong(name, "a workplane or shape")),
        }
    }

    pub(super) fn place(&self, name: &str) -> Result<Placement> {
        let json = self
            .json(name)
            .ok_or_else(|| self.wrong(name, "a location"))?;
        self.place_of(name, json)
    }

    pub(super) fn place_of(&self, name: &str, json: &Json) -> Result<Placement> {
        if let Some(at) = reference(json) {
            return match self.value(at)? {
                Value::Place(place) | Value::Object(Object::Place(place)) => Ok(*place),
                Value::Object(Object::Point(p)) => Ok(Placement::translation(p.x, p.y, p.z)),
                _ => Err(self.wrong(name, "a location")),
            };
        }
        frame(json).ok_or_else(|| self.wrong(name, "a location"))
    }
}

fn number(json: &Json) -> Option<f64> {
    json.as_f64().filter(|n| n.is_finite())
}

pub(super) fn vector(json: &Json) -> Option<Vector> {
    let items = json.as_array()?;
    let numbers: Vec<f64> = items.iter().map(number).collect::<Option<_>>()?;
    let three: [f64; 3] = numbers.try_into().ok()?;
    three
        .iter()
        .all(|n| n.abs() <= LARGEST)
        .then(|| three.into())
}

pub(super) fn frame(json: &Json) -> Option<Placement> {
    let frame: Frame = serde_json::from_value(json.clone()).ok()?;
    frame.placement().ok()
}
