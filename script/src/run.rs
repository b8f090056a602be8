//! One evaluation: source in, declaration or recipe out.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::language::Type;
use assemcad_model::param::ParamSpec;
use serde_json::{Map, Value as Json};
use starlark::codemap::FileSpanRef;
use starlark::environment::Module;
use starlark::eval::{BeforeStmtFunc, BeforeStmtFuncDyn, Evaluator};
use starlark::syntax::{AstModule, Dialect, DialectTypes};
use starlark::values::Value;

use crate::fault::{self, Fault, Lines};
use crate::language::{self, guard, session::Declaration, session::Session};
use crate::limits::Limits;
use crate::recorder::Shared;
use crate::values::handle;

/// The source of a factory and under what it is evaluated.
#[derive(Debug, Clone)]
pub(crate) struct Job {
    pub(crate) name: String,
    pub(crate) source: Arc<str>,
    pub(crate) limits: Limits,
}

/// What `build(p)` made: the recipe and the line of each call.
pub(crate) type Built = (assemcad_model::recipe::Recipe, Vec<u32>);

/// The longest designation of a part, in bytes.
const MOST_DESIGNATION: usize = 80;

/// The language: Starlark with statements at the top level and keyword-only parameters; types may be
/// written and mean nothing.
pub(crate) fn dialect() -> Dialect {
    Dialect {
        enable_load: false,
        enable_keyword_only_arguments: true,
        enable_positional_only_arguments: true,
        enable_top_level_stmt: true,
        enable_types: DialectTypes::ParseOnly,
        // Only so that the lexer tells them from texts: they are rewritten before the parser runs.
        enable_f_strings: true,
        ..Dialect::Standard
    }
}

impl Job {
    /// Evaluates the top level and gives what it declared.
    pub(crate) fn declare(self) -> Result<Declaration, Vec<Diagnostic>> {
        self.in_thread(|job, cancelled| {
            job.evaluate(cancelled, &Map::new(), |job, session, module, _, _| {
                let mut found = Vec::new();
                let declaration = session.declaration.borrow_mut().take();
                if declaration.is_none() {
                    found.push(
                        Fault::new("the source does not call factory(doc = ..., params = ...)")
                            .hint("call it once at the top level")
                            .diagnostic(&job.name, None),
                    );
                }
                match module.get("build").map(Value::get_type) {
                    Some("function") => {}
                    _ => found.push(
                        Fault::new("the source does not define the function build(p)")
                            .hint("write `def build(p):` and return a Workplane from it")
                            .diagnostic(&job.name, None),
                    ),
                }
                declaration.filter(|_| found.is_empty()).ok_or(found)
            })
        })
    }

    /// Evaluates the top level and then `build(p)` with checked parameters, and `designation(p)` where
    /// the source defines it.
    pub(crate) fn build(
        self,
        specs: Vec<ParamSpec>,
        params: Map<String, Json>,
    ) -> Result<(Built, Option<String>), Vec<Diagnostic>> {
        self.in_thread(move |job, cancelled| {
            job.evaluate(cancelled, &Map::new(), |job, session, module, eval, _| {
                session.building.set(true);
                let Some(build) = module.get("build") else {
                    return Err(vec![
                        Fault::new("the source does not define the function build(p)")
                            .diagnostic(&job.name, None),
                    ]);
                };
                let p = crate::values::params::record(eval.heap(), &specs, &params);
                let result = eval.eval_function(build, &[p], &[]);
                // A rule between parameters that does not hold explains whatever came after it.
                let broken = session.broken_rules.take();
                if !broken.is_empty() {
                    return Err(broken.iter().map(|m| fault::of_params(m)).collect());
                }
                let result = result.map_err(|e| vec![fault::diagnostic(&job.name, session, &e)])?;
                let hint = "end build(p) with `return` and the finished workplane";
                let made = built(job, session, "build(p) returned", result, hint)?;
                // Only now: what it is called is asked of a part that there is.
                let Some(designation) = module.get("designation") else {
                    return Ok((made, None));
                };
                let name = eval
                    .eval_function(designation, &[p], &[])
                    .map_err(|e| vec![fault::diagnostic(&job.name, session, &e)])?;
                Ok((made, designated(job, name)?))
            })
        })
    }

    /// Evaluates a plain script, which leaves its part in `result` or gives it to `show_object`.
    pub(crate) fn script(self) -> Result<Built, Vec<Diagnostic>> {
        self.in_thread(|job, cancelled| {
            job.evaluate(cancelled, &Map::new(), |job, session, module, _, _| {
                if session.declaration.borrow().is_some() {
                    return Err(vec![
                        Fault::new("a plain script does not call factory(...)")
                            .hint("leave factory and build out, or keep it as a factory")
                            .diagnostic(&job.name, None),
                    ]);
                }
                let hint = "leave the finished workplane in `result`";
                match (module.get("result"), session.shown.get()) {
                    (Some(result), _) => built(job, session, "`result` is", result, hint),
                    (None, Some(shown)) => Ok(session.recorder.get().recipe(shown)),
                    (None, None) => Err(vec![
                        Fault::new("the script leaves no `result`")
                            .hint("end it with `result = ...`, the finished workplane")
                            .diagnostic(&job.name, None),
                    ]),
                }
            })
        })
    }

    /// Evaluates one expression over the names that are given to it, to a finite number.
    pub(crate) fn number(self, given: Map<String, Json>) -> Result<f64, Vec<Diagnostic>> {
        self.in_thread(move |job, cancelled| {
            job.evaluate(cancelled, &given, |job, _, _, _, value| {
                language::number(value, "the expression's value")
                    .map_err(|fault| vec![fault.diagnostic(&job.name, None)])
            })
        })
    }

    fn in_thread<T: Send + 'static>(
        self,
        work: impl FnOnce(&Self, Arc<AtomicBool>) -> Result<T, Vec<Diagnostic>> + Send + 'static,
    ) -> Result<T, Vec<Diagnostic>> {
        let (limits, name) = (self.limits.clone(), self.name.clone());
        crate::thread::run(&limits, move |cancelled| work(&self, cancelled))
            .unwrap_or_else(|fault| Err(vec![fault.diagnostic(&name, None)]))
    }

    /// Reads, checks and evaluates the top level, where `given` names are bound already, then hands
    /// over to `finish` with the value of the last statement.
    fn evaluate<T>(
        &self,
        cancelled: Arc<AtomicBool>,
        given: &Map<String, Json>,
        finish: impl for<'v, 'a> FnOnce(
            &Self,
            &Session,
            &Module<'v>,
            &mut Evaluator<'v, 'a, '_>,
            Value<'v>,
        ) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<T, Vec<Diagnostic>> {
        let dialect = dialect();
        let all = |faults: Vec<Fault>| -> Vec<Diagnostic> {
            faults
                .into_iter()
                .map(|f| f.diagnostic(&self.name, None))
                .collect()
        };
        let source = crate::python::rewrite(&self.source, &dialect).map_err(all)?;
        let faults = crate::scan::scan(&source, &dialect, &self.limits);
        if !faults.is_empty() {
            return Err(all(faults));
        }
        let lines = Lines(crate::scan::calls(&source, &dialect));
        let session = Session::new(&self.limits, lines, &source);
        let one = |e: &starlark::Error| vec![fault::diagnostic(&self.name, &session, e)];
        let mut ast = AstModule::parse(&self.name, source, &dialect).map_err(|e| one(&e))?;
        ast.replace_binary_operators(&guard::operators());
        let deadline = Instant::now() + self.limits.time;
        let ended = move || cancelled.load(Ordering::Relaxed) || Instant::now() > deadline;
        Module::with_temp_heap(|module| {
            let mut eval = Evaluator::new(&module);
            eval.extra = Some(&session);
            // The collector walks values by recursion, as deep as a script has nested them; the limit
            // on memory makes it needless.
            eval.disable_gc();
            eval.set_check_cancelled(Box::new(ended.clone()));
            let prepared = eval
                .set_max_callstack_size(self.limits.call_depth)
                .and_then(|()| eval.set_max_heap_size(self.limits.heap_bytes))
                .and_then(|()| eval.set_max_tick_count(self.limits.ticks));
            if prepared.is_err() {
                return Err(vec![
                    Fault::new("the limits of the evaluation cannot be set")
                        .diagnostic(&self.name, None),
                ]);
            }
            eval.before_stmt_for_dap(BeforeStmtFunc::from_dyn(Box::new(Watch {
                limits: self.limits.clone(),
                statements: 0,
                recorder: session.recorder.clone(),
                ended,
            })));
            crate::values::params::bind(&module, given);
            let last = eval
                .eval_module(ast, language::globals())
                .map_err(|e| one(&e))?;
            finish(self, &session, &module, &mut eval, last)
        })
    }
}

/// What `designation(p)` returned: a short text of one line, or None.
fn designated(job: &Job, name: Value<'_>) -> Result<Option<String>, Vec<Diagnostic>> {
    if name.is_none() {
        return Ok(None);
    }
    match name.unpack_str() {
        Some(text)
            if !text.is_empty()
                && text.len() <= MOST_DESIGNATION
                && !text.chars().any(char::is_control) =>
        {
            Ok(Some(text.to_owned()))
        }
        _ => Err(vec![
            Fault::new("designation(p) returned neither None nor a short text of one line")
                .hint(format!(
                    "return None, or a designation of at most {MOST_DESIGNATION} characters"
                ))
                .diagnostic(&job.name, None),
        ]),
    }
}

/// The recipe of what a script left, where that is a part.
fn built(
    job: &Job,
    session: &Session,
    what: &str,
    result: Value<'_>,
    hint: &str,
) -> Result<Built, Vec<Diagnostic>> {
    match handle(result) {
        Some(part) if matches!(part.kind, Type::Workplane | Type::Shape) => {
            Ok(session.recorder.get().recipe(part.node.index))
        }
        _ => Err(vec![
            Fault::new(format!(
                "{what} {} and not a workplane",
                language::kind_of(result)
            ))
            .hint(hint)
            .diagnostic(&job.name, None),
        ]),
    }
}

/// Looks at every statement before it is carried out.
struct Watch<F> {
    limits: Limits,
    statements: u64,
    recorder: Shared,
    ended: F,
}

impl<'e, F: Fn() -> bool> BeforeStmtFuncDyn<'e> for Watch<F> {
    fn call<'v>(
        &mut self,
        span: FileSpanRef<'_>,
        _continued: bool,
        eval: &mut Evaluator<'v, '_, 'e>,
    ) -> starlark::Result<()> {
        self.statements += 1;
        self.recorder.get().statement = Some(span.span.begin().get());
        let fault = if self.statements > self.limits.statements {
            Fault::new(format!(
                "more than {} statements are carried out (limit statements)",
                self.limits.statements
            ))
            .hint("do less work in loops")
        } else if eval.heap().allocated_bytes() > self.limits.heap_bytes {
            fault::too_much_memory(&self.limits)
        } else if self.statements.is_multiple_of(256) && (self.ended)() {
            fault::too_long(&self.limits)
        } else {
            return Ok(());
        };
        let fault = match fault::line_at(&span.to_file_span()) {
            Some(line) => fault.line(line),
            None => fault,
        };
        Err(starlark::Error::new_native(anyhow::Error::new(fault)))
    }
}
