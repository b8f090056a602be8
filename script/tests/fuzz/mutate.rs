//! Sources made worse, step by step, the same way for the same seed.

/// A sequence of numbers that is the same on every machine (SplitMix64, Steele et al. 2014).
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`; 0 where there is none.
    pub fn below(&mut self, n: usize) -> usize {
        (self.roll() % n.max(1) as u64) as usize
    }

    pub fn pick<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }
}

/// What a mutation puts in: words of the language, of Python, and values at their ends.
const WORDS: [&str; 92] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ".",
    ":",
    ";",
    "=",
    "==",
    "+",
    "-",
    "*",
    "/",
    "//",
    "%",
    "<<",
    ">>",
    "&",
    "|",
    "^",
    "~",
    "**",
    "+=",
    "*=",
    "<",
    "!=",
    "->",
    "@",
    "\\",
    "\n",
    "\t",
    "\r\n",
    "    ",
    "#",
    "\"",
    "'",
    "\"\"\"",
    "f\"{",
    "}\"",
    "r\"",
    "b\"",
    "and",
    "or",
    "not",
    "in",
    "is",
    "if",
    "else",
    "elif",
    "for",
    "while",
    "def",
    "return",
    "lambda",
    "pass",
    "break",
    "continue",
    "import",
    "from",
    "load",
    "class",
    "None",
    "True",
    "0",
    "-1",
    "1",
    "1e308",
    "1e-308",
    "1e999",
    "9223372036854775807",
    "99999999999999999999",
    "0x7fffffff",
    "0.1",
    "p",
    "cq",
    "math",
    "range",
    "len",
    "str",
    "factory",
    "number",
    "records",
    "require",
    "port",
    "getattr",
    "fail",
    "sorted",
    "__add",
    "\u{e9}",
];

/// The pieces of a source: words, numbers, single signs, stretches of blanks, ends of lines.
fn pieces(source: &str) -> Vec<&str> {
    let class = |c: char| match c {
        _ if c.is_alphanumeric() || c == '_' => 0,
        ' ' | '\t' => 1,
        _ => 2,
    };
    let mut found = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let end = match class(first) {
            2 => first.len_utf8(),
            kind => rest.find(|c| class(c) != kind).unwrap_or(rest.len()),
        };
        let (piece, after) = rest.split_at(end);
        found.push(piece);
        rest = after;
    }
    found
}

/// What takes the place of a word or number, so that the source still reads well.
const VALUES: [&str; 34] = [
    "0",
    "1",
    "-1",
    "2",
    "7",
    "1000",
    "20000",
    "0.0",
    "-0.0",
    "1e-9",
    "1e5",
    "1e308",
    "2147483647",
    "9223372036854775807",
    "True",
    "None",
    "\"\"",
    "\">Z\"",
    "\"|Z or #X\"",
    "(0, 0)",
    "(1, 2, 3)",
    "[]",
    "[(0, 0), (1, 1)]",
    "{}",
    "p",
    "cq",
    "math.pi",
    "range(9)",
    "len",
    "cq.Workplane()",
    "cq.Vector(1, 2, 3)",
    "(lambda x: x)",
    "cq.Plane.XY()",
    "\"%s\"",
];

/// A word or number becomes another.
fn by_values(source: &str, other: &str, dice: &mut Dice) -> String {
    let is_word = |piece: &&str| piece.starts_with(|c: char| c.is_alphanumeric());
    let mut all = pieces(source);
    let words: Vec<usize> = (0..all.len()).filter(|i| is_word(&all[*i])).collect();
    let others: Vec<&str> = pieces(other).into_iter().filter(is_word).collect();
    if words.is_empty() || others.is_empty() {
        return other.to_owned();
    }
    let at = dice.pick(&words);
    all[at] = match dice.below(3) {
        0 => dice.pick(&others),
        1 => all[dice.pick(&words)],
        _ => dice.pick(&VALUES),
    };
    all.concat()
}

/// One step: by words, by pieces, by lines, by bytes, or with a stretch of another source.
fn step(source: &str, other: &str, dice: &mut Dice) -> String {
    match dice.below(20) {
        0..=9 => by_values(source, other, dice),
        10..=14 => by_pieces(source, other, dice),
        15 | 16 => by_lines(source, other, dice),
        _ => by_bytes(source, dice),
    }
}

fn by_pieces(source: &str, other: &str, dice: &mut Dice) -> String {
    let (mut all, others) = (pieces(source), pieces(other));
    if all.is_empty() || others.is_empty() {
        return other.to_owned();
    }
    let (at, to) = (dice.below(all.len()), dice.below(all.len()));
    match dice.below(6) {
        0 => drop(all.remove(at)),
        1 => all.insert(to, all[at]),
        2 => all.swap(at, to),
        3 => all[at] = dice.pick(&others),
        4 => all.insert(at, dice.pick(&WORDS)),
        _ => all[at] = dice.pick(&WORDS),
    }
    all.concat()
}

fn by_lines(source: &str, other: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<&str> = source.split_inclusive('\n').collect();
    let others: Vec<&str> = other.split_inclusive('\n').collect();
    if lines.is_empty() || others.is_empty() {
        return other.to_owned();
    }
    let (at, to) = (dice.below(lines.len()), dice.below(lines.len()));
    match dice.below(5) {
        0 => drop(lines.drain(at.min(to)..at.max(to))),
        1 => lines.insert(to, lines[at]),
        2 => lines.swap(at, to),
        3 => lines.insert(at, dice.pick(&others)),
        _ => {
            lines.truncate(at);
            lines.extend(&others[dice.below(others.len())..]);
        }
    }
    lines.concat()
}

fn by_bytes(source: &str, dice: &mut Dice) -> String {
    let mut bytes = source.as_bytes().to_vec();
    if bytes.is_empty() {
        return "\0".to_owned();
    }
    let at = dice.below(bytes.len());
    let byte = (dice.roll() & 0xff) as u8;
    match dice.below(5) {
        0 => bytes[at] = byte,
        1 => bytes[at] ^= 1 << dice.below(8),
        2 => bytes.insert(at, byte),
        3 => bytes.truncate(at),
        _ => {
            // The same stretch again and again.
            let end = (at + 1 + dice.below(8)).min(bytes.len());
            let stretch = bytes[at..end].repeat(1 + dice.below(200));
            bytes.splice(at..at, stretch);
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A source of the corpus, made worse by one to six steps.
pub fn mutated(corpus: &[String], dice: &mut Dice) -> String {
    let mut source = dice.pick(corpus);
    for _ in 0..=dice.below(6) {
        source = step(&source, &dice.pick(corpus), dice);
    }
    source
}

/// A few words in a row, some of them names that are known.
pub fn expression(names: &[&str], dice: &mut Dice) -> String {
    let mut text = String::new();
    for _ in 0..=dice.below(8) {
        text.push_str(match dice.below(3) {
            0 => dice.pick(&WORDS),
            _ => dice.pick(names),
        });
        if dice.below(2) == 0 {
            text.push(' ');
        }
    }
    text
}
