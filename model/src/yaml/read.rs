//! From text to nodes with lines.

use std::collections::BTreeMap;

use saphyr_parser::{Event, Parser, ScalarStyle, ScanError, Span};

use super::{Entries, Key, Kind, Node};
use crate::diagnostic::{Code, Diagnostic};
use crate::param::clip;
use crate::told::Capped;

/// The longest text that is read, in bytes: some ten thousand parts.
pub const MOST_BYTES: usize = 2 << 20;

/// How deep lists and mappings may be nested.
pub const MOST_DEPTH: usize = 32;

/// How many nodes a document may have once its aliases are written out.
pub const MOST_NODES: usize = 200_000;

/// What was read.
#[derive(Debug)]
pub struct Read {
    /// The document; none where the text is no YAML at all.
    pub node: Option<Node>,
    /// Everything that is wrong, with the line in its place, and comments as a warning.
    pub faults: Vec<Diagnostic>,
}

/// Reads one document.
#[must_use]
pub fn read(text: &str) -> Read {
    let mut found = Capped::new();
    if text.len() > MOST_BYTES {
        let d = fault(1, "the text is too long")
            .found(format!("{} bytes", text.len()))
            .expected(format!("at most {MOST_BYTES} bytes"));
        return Read {
            node: None,
            faults: vec![d],
        };
    }
    let mut reader = Reader {
        faults: &mut found,
        anchors: BTreeMap::new(),
        open: Vec::new(),
        root: None,
        nodes: 0,
        copied: 0,
        texts: Vec::new(),
    };
    let ended = reader.run(text);
    let node = reader.root.take();
    let spans = core::mem::take(&mut reader.texts);
    let mut faults = found.told();
    if let Err(stop) = ended {
        faults.push(*stop);
        return Read { node: None, faults };
    }
    if node.is_none() && faults.is_empty() {
        faults.push(fault(1, "the text is empty"));
    }
    if let Some(line) = first_comment(text, &spans) {
        faults.push(
            Diagnostic::warning(
                Code::CommentLost,
                format!("line {line}"),
                "comments are not kept: the assembly is stored in one canonical form",
            )
            .hint("put what must stay into 'notes', which an assembly, a part and a mate may have"),
        );
    }
    Read { node, faults }
}

fn fault(line: usize, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error(Code::YamlInvalid, format!("line {line}"), message)
}

/// A list or mapping whose end was not met yet.
struct Open {
    line: usize,
    anchor: usize,
    /// Nodes counted before it, so that its own size is known at its end.
    before: usize,
    kind: Kind,
    key: Option<Key>,
}

struct Reader<'a> {
    faults: &'a mut Capped,
    /// Anchored nodes with their sizes. Ordered, so that nothing depends on a hash.
    anchors: BTreeMap<usize, (Node, usize)>,
    open: Vec<Open>,
    root: Option<Node>,
    nodes: usize,
    /// Nodes that were copied for anchors.
    copied: usize,
    /// Where scalars stand in the text, in characters: a `#` in there is no comment.
    texts: Vec<(usize, usize)>,
}

impl Reader<'_> {
    fn run(&mut self, text: &str) -> Result<(), Box<Diagnostic>> {
        let mut parser = Parser::new_from_str(text);
        let mut documents = 0;
        while let Some(event) = parser.next_event() {
            let (event, span) = event.map_err(|e| Box::new(syntax(&e)))?;
            let line = span.start.line();
            match event {
                Event::DocumentStart(_) => {
                    documents += 1;
                    if documents > 1 {
                        return Err(Box::new(fault(line, "only one document is read")));
                    }
                }
                Event::Alias(anchor) => self.alias(anchor, line)?,
                Event::Scalar(text, style, anchor, tag) => {
                    self.texts.push((span.start.index(), span.end.index()));
                    self.untagged(tag.is_some(), line);
                    let plain = style == ScalarStyle::Plain;
                    let kind = Kind::Scalar {
                        text: text.into_owned(),
                        plain,
                    };
                    self.count(1, line)?;
                    let node = Node { line, kind };
                    self.anchor(anchor, &node, 1)?;
                    self.put(node);
                }
                Event::SequenceStart(anchor, tag) => {
                    self.untagged(tag.is_some(), line);
                    self.begin(Kind::List(Vec::new()), anchor, &span)?;
                }
                Event::MappingStart(anchor, tag) => {
                    self.untagged(tag.is_some(), line);
                    self.begin(Kind::Map(Entries::default()), anchor, &span)?;
                }
                Event::SequenceEnd | Event::MappingEnd => {
                    if let Some(open) = self.open.pop() {
                        let node = Node {
                            line: open.line,
                            kind: open.kind,
                        };
                        self.anchor(open.anchor, &node, self.nodes - open.before)?;
                        self.put(node);
                    }
                }
                Event::Nothing | Event::StreamStart | Event::StreamEnd | Event::DocumentEnd => {}
            }
        }
        Ok(())
    }

    fn begin(&mut self, kind: Kind, anchor: usize, span: &Span) -> Result<(), Box<Diagnostic>> {
        let line = span.start.line();
        if self.open.len() >= MOST_DEPTH {
            let message = format!("lists and mappings are nested more than {MOST_DEPTH} deep");
            return Err(Box::new(fault(line, message)));
        }
        let before = self.nodes;
        self.count(1, line)?;
        self.open.push(Open {
            line,
            anchor,
            before,
            kind,
            key: None,
        });
        Ok(())
    }

    fn alias(&mut self, anchor: usize, line: usize) -> Result<(), Box<Diagnostic>> {
        let Some((node, size)) = self.anchors.get(&anchor) else {
            // An anchor that is still open would hold itself.
            return Err(Box::new(fault(line, "an alias within its own anchor")));
        };
        // Counted before it is copied: aliases of aliases grow without bound otherwise.
        let (size, depth) = (*size, depth(node));
        if self.open.len() + depth > MOST_DEPTH {
            let message = format!("lists and mappings are nested more than {MOST_DEPTH} deep");
            return Err(Box::new(fault(line, message)));
        }
        self.nodes += size;
        if self.nodes > MOST_NODES {
            return Err(Box::new(too_many(line)));
        }
        let mut node = node.clone();
        node.line = line;
        self.put(node);
        Ok(())
    }

    fn count(&mut self, more: usize, line: usize) -> Result<(), Box<Diagnostic>> {
        self.nodes += more;
        if self.nodes > MOST_NODES {
            return Err(Box::new(too_many(line)));
        }
        Ok(())
    }

    fn anchor(&mut self, anchor: usize, node: &Node, size: usize) -> Result<(), Box<Diagnostic>> {
        // Nought is "no anchor".
        if anchor != 0 {
            // Anchors within anchors copy the innermost as often as they are nested.
            self.copied += size;
            if self.copied > MOST_NODES {
                return Err(Box::new(too_many(node.line)));
            }
            self.anchors.insert(anchor, (node.clone(), size));
        }
        Ok(())
    }

    fn untagged(&mut self, tagged: bool, line: usize) {
        if tagged {
            self.faults.push(|| {
                fault(line, "tags (such as !!str) have no meaning here")
                    .hint("quote what must be text, and leave the tag out")
            });
        }
    }

    /// Gives a finished node to what it stands in.
    fn put(&mut self, node: Node) {
        let Some(open) = self.open.last_mut() else {
            self.root = Some(node);
            return;
        };
        match (&mut open.kind, open.key.take()) {
            (Kind::List(items), _) => items.push(node),
            (Kind::Map(entries), Some(key)) => {
                // The first one stays, so that all else can be checked.
                if let Err((key, first)) = entries.add(key, node) {
                    self.faults.push(|| {
                        let name = clip(&key.name);
                        let message =
                            format!("the key '{name}' is given twice, first on line {first}");
                        fault(key.line, message)
                    });
                }
            }
            (Kind::Map(_), None) => match node.kind {
                Kind::Scalar { text, .. } => {
                    open.key = Some(Key {
                        name: text,
                        line: node.line,
                    });
                }
                _ => {
                    self.faults
                        .push(|| fault(node.line, "a list or mapping cannot be a key"));
                    open.key = Some(Key {
                        name: String::new(),
                        line: node.line,
                    });
                }
            },
            (Kind::Scalar { .. }, _) => {}
        }
    }
}

fn depth(node: &Node) -> usize {
    match &node.kind {
        Kind::Scalar { .. } => 0,
        Kind::List(items) => 1 + items.iter().map(depth).max().unwrap_or(0),
        Kind::Map(entries) => 1 + entries.iter().map(|(_, n)| depth(n)).max().unwrap_or(0),
    }
}

fn too_many(line: usize) -> Diagnostic {
    fault(
        line,
        format!("more than {MOST_NODES} values, aliases written out"),
    )
    .hint("do not nest anchors and aliases")
}

fn syntax(e: &ScanError) -> Diagnostic {
    let place = e.marker();
    fault(
        place.line(),
        format!("this is no YAML: {} (column {})", e.info(), place.col() + 1),
    )
    .hint("indent with spaces, quote texts that hold ': ' or ' #', close every bracket")
}

/// The line of the first `#` that stands in no scalar.
fn first_comment(text: &str, scalars: &[(usize, usize)]) -> Option<usize> {
    let mut line = 1;
    let mut scalars = scalars.iter().peekable();
    let mut before = '\n';
    let mut comment = false;
    for (i, c) in text.chars().enumerate() {
        while scalars.next_if(|(_, end)| *end <= i).is_some() {}
        let inside = scalars.peek().is_some_and(|(start, _)| *start <= i);
        // A '#' that touches what stands before it is part of an anchor's name.
        comment |= c == '#' && !inside && before.is_whitespace();
        if comment {
            return Some(line);
        }
        if c == '\n' {
            line += 1;
        }
        before = c;
    }
    None
}
