//! Source code with all mutations of it, each behind a condition.

use std::collections::HashSet;

use proc_macro2::Span;
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    BinOp, Block, Expr, ExprLit, ExprMatch, Ident, ImplItemFn, ItemConst, ItemFn, ItemImpl, ItemMod,
    ItemStatic, Member, Pat, ReturnType, Signature, Stmt, Type, UnOp, parse_quote,
};

use crate::replacements;

/// A change of one place in the source code.
pub struct Mutation {
    pub id: u32,
    /// The file, the line, the function and the change, separated by tabs.
    pub place: String,
}

/// Rewrites a file. `file` is its name; the mutations are numbered from `first`, and those in `dropped` are
/// left out.
pub fn rewrite(source: &str, file: &str, first: u32, dropped: &HashSet<u32>) -> syn::Result<Rewritten> {
    let mut syntax = syn::parse_file(source)?;
    let mut rewriter = Rewriter {
        file,
        dropped,
        next: first,
        function: Vec::new(),
        mutations: Vec::new(),
    };
    rewriter.visit_file_mut(&mut syntax);
    Ok(Rewritten {
        source: prettyplease::unparse(&syntax),
        mutations: rewriter.mutations,
        next: rewriter.next,
    })
}

/// The result of [`rewrite`].
pub struct Rewritten {
    pub source: String,
    pub mutations: Vec<Mutation>,
    /// The number of the next mutation.
    pub next: u32,
}

/// The names of the modules that a file declares for tests only.
pub fn test_modules(source: &str) -> syn::Result<Vec<String>> {
    let syntax = syn::parse_file(source)?;
    Ok(syntax
        .items
        .iter()
        .filter_map(|item| match item {
            syn::Item::Mod(module) if is_for_tests(&module.attrs) => Some(module.ident.to_string()),
            _ => None,
        })
        .collect())
}

struct Rewriter<'a> {
    file: &'a str,
    dropped: &'a HashSet<u32>,
    next: u32,
    function: Vec<String>,
    mutations: Vec<Mutation>,
}

impl Rewriter<'_> {
    /// The condition that a mutation is chosen; none if it is dropped.
    fn offer(&mut self, span: Span, change: &str) -> Option<Expr> {
        let id = self.next;
        self.next += 1;
        if self.dropped.contains(&id) {
            return None;
        }
        let change = change.split_whitespace().collect::<Vec<_>>().join(" ");
        let place = format!(
            "{}:{}\t{}\t{change}",
            self.file,
            span.start().line,
            self.function.join("::")
        );
        self.mutations.push(Mutation { id, place });
        Some(parse_quote!(crate::mutated(#id)))
    }

    /// `mutated` if the mutation is chosen, otherwise `original`.
    fn either(&mut self, span: Span, change: &str, mutated: &Expr, original: Expr) -> Expr {
        match self.offer(span, change) {
            Some(chosen) => parse_quote!((if #chosen { #mutated } else { #original })),
            None => original,
        }
    }

    /// A condition that may be always true or always false.
    fn forced(&mut self, condition: &mut Expr) {
        let (span, text) = (condition.span(), condition.to_token_stream());
        self.visit_expr_mut(condition);
        let never = self.either(
            span,
            &format!("{text} -> false"),
            &parse_quote!(false),
            condition.clone(),
        );
        *condition = self.either(span, &format!("{text} -> true"), &parse_quote!(true), never);
    }

    /// A function that may return at once.
    fn body(&mut self, name: String, signature: &Signature, block: &mut Block) {
        // A function for compile time cannot read which mutation is chosen.
        if signature.constness.is_some() {
            return;
        }
        self.function.push(name);
        let mut statements: Vec<Stmt> = Vec::new();
        let span = signature.ident.span();
        if let ReturnType::Type(_, output) = &signature.output {
            for value in replacements::values(output) {
                if let Some(chosen) = self.offer(span, &format!("return {}", value.to_token_stream())) {
                    statements.push(parse_quote!(if #chosen { return #value; }));
                }
            }
        } else if let Some(chosen) = self.offer(span, "return") {
            statements.push(parse_quote!(if #chosen { return; }));
        }
        visit_mut::visit_block_mut(self, block);
        statements.append(&mut block.stmts);
        block.stmts = statements;
        self.function.pop();
    }

    fn binary(&mut self, expression: &mut Expr, text: &str, span: Span) {
        let Expr::Binary(binary) = expression else { return };
        let operator = binary.op;
        let name = operator.to_token_stream().to_string();
        self.visit_expr_mut(&mut binary.left);
        self.visit_expr_mut(&mut binary.right);
        let (left, right) = (&binary.left, &binary.right);
        let before = self.mutations.len();
        let mut value: Expr = parse_quote!(left #operator right);
        for other in replacements::operators(&name) {
            let replaced: BinOp = syn::parse_str(other).expect("the table has operators");
            let change = format!("{name} -> {other} in {text}");
            value = self.either(span, &change, &parse_quote!(left #replaced right), value);
        }
        if self.mutations.len() == before {
            return;
        }
        let compares = ["<", "<=", ">", ">=", "==", "!="].contains(&name.as_str());
        *expression = if compares {
            parse_quote!((match (&(#left), &(#right)) { (left, right) => #value }))
        } else {
            parse_quote!((match (#left, #right) { (left, right) => #value }))
        };
    }

    /// `a && b` is false if a is false, otherwise b; `a || b` is true if a is true, otherwise b.
    fn lazy(&mut self, expression: &mut Expr, text: &str, span: Span) {
        let Expr::Binary(binary) = expression else { return };
        self.visit_expr_mut(&mut binary.left);
        self.visit_expr_mut(&mut binary.right);
        let (left, right) = (&binary.left, &binary.right);
        let is_or = matches!(binary.op, BinOp::Or(_));
        let other = if is_or { "&&" } else { "||" };
        if let Some(chosen) = self.offer(span, &format!("{other} in {text}")) {
            *expression = parse_quote!((match #chosen != #is_or {
                decides => if (#left) == decides { decides } else { #right }
            }));
        }
    }

    fn assignment(&mut self, expression: &mut Expr, text: &str, span: Span) {
        let Expr::Binary(binary) = expression else { return };
        self.visit_expr_mut(&mut binary.right);
        let other = match binary.op {
            BinOp::AddAssign(_) => "-=",
            BinOp::SubAssign(_) | BinOp::MulAssign(_) => "+=",
            BinOp::BitOrAssign(_) => "&=",
            BinOp::BitAndAssign(_) => "|=",
            _ => return,
        };
        let (left, operator, right) = (&binary.left, binary.op, &binary.right);
        let replaced: BinOp = syn::parse_str(other).expect("the table has operators");
        if let Some(chosen) = self.offer(span, &format!("{other} in {text}")) {
            *expression = parse_quote!((match #right {
                right => if #chosen { #left #replaced right } else { #left #operator right }
            }));
        }
    }

    fn literal(&mut self, expression: &mut Expr, text: &str, span: Span) {
        let Expr::Lit(ExprLit { lit, .. }) = expression else {
            return;
        };
        for other in replacements::literals(lit) {
            let mutated = syn::parse_str(&other).expect("a number is an expression");
            *expression = self.either(span, &format!("{text} -> {other}"), &mutated, expression.clone());
        }
    }

    fn method(&mut self, expression: &mut Expr, text: &str) {
        visit_mut::visit_expr_mut(self, expression);
        let Expr::MethodCall(call) = expression else {
            return;
        };
        let Some(other) = replacements::method(&call.method.to_string(), text) else {
            return;
        };
        let (span, receiver, arguments) = (call.method.span(), &call.receiver, &call.args);
        let (method, replaced) = (&call.method, Ident::new(other, span));
        if let Some(chosen) = self.offer(span, &format!("{other} in {text}")) {
            *expression = parse_quote!((match #receiver {
                mut receiver => if #chosen { receiver.#replaced(#arguments) } else { receiver.#method(#arguments) }
            }));
        }
    }

    fn arms(&mut self, choice: &mut ExprMatch) {
        self.visit_expr_mut(&mut choice.expr);
        let last = choice.arms.len().saturating_sub(1);
        let ends_in_any = choice
            .arms
            .last()
            .is_some_and(|arm| matches!(arm.pat, Pat::Wild(_)));
        for (place, arm) in choice.arms.iter_mut().enumerate() {
            if let Some((_, guard)) = &mut arm.guard {
                self.condition(guard);
            } else if ends_in_any && place < last {
                let change = format!("delete {}", arm.pat.to_token_stream());
                if let Some(chosen) = self.offer(arm.pat.span(), &change) {
                    arm.guard = Some((Default::default(), parse_quote!(!#chosen)));
                }
            }
            self.visit_expr_mut(&mut arm.body);
        }
    }

    /// The condition of an `if` or of an arm; one with `let` cannot be forced.
    fn condition(&mut self, condition: &mut Expr) {
        if condition.to_token_stream().to_string().contains("let ") {
            self.visit_expr_mut(condition);
        } else {
            self.forced(condition);
        }
    }
}

impl VisitMut for Rewriter<'_> {
    fn visit_item_fn_mut(&mut self, function: &mut ItemFn) {
        if !is_for_tests(&function.attrs) {
            self.body(function.sig.ident.to_string(), &function.sig, &mut function.block);
        }
    }

    fn visit_impl_item_fn_mut(&mut self, function: &mut ImplItemFn) {
        self.body(function.sig.ident.to_string(), &function.sig, &mut function.block);
    }

    fn visit_item_mod_mut(&mut self, module: &mut ItemMod) {
        if !is_for_tests(&module.attrs) {
            visit_mut::visit_item_mod_mut(self, module);
        }
    }

    fn visit_item_impl_mut(&mut self, implementation: &mut ItemImpl) {
        let message = |name: &Ident| name == "Debug" || name == "Display";
        if let Some((_, path, _)) = &implementation.trait_
            && path
                .segments
                .last()
                .is_some_and(|segment| message(&segment.ident))
        {
            return;
        }
        let name = implementation.self_ty.to_token_stream().to_string();
        self.function
            .push(name.split_whitespace().next().unwrap_or_default().to_owned());
        visit_mut::visit_item_impl_mut(self, implementation);
        self.function.pop();
    }

    // Constants, types, patterns and attributes are evaluated by the compiler.
    fn visit_item_const_mut(&mut self, _: &mut ItemConst) {}
    fn visit_item_static_mut(&mut self, _: &mut ItemStatic) {}
    fn visit_impl_item_const_mut(&mut self, _: &mut syn::ImplItemConst) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
    fn visit_pat_mut(&mut self, _: &mut Pat) {}
    fn visit_attribute_mut(&mut self, _: &mut syn::Attribute) {}
    fn visit_generic_argument_mut(&mut self, _: &mut syn::GenericArgument) {}
    fn visit_member_mut(&mut self, _: &mut Member) {}
    fn visit_expr_repeat_mut(&mut self, repeat: &mut syn::ExprRepeat) {
        self.visit_expr_mut(&mut repeat.expr);
    }

    fn visit_stmt_mut(&mut self, statement: &mut Stmt) {
        let (span, text) = (statement.span(), statement.to_token_stream().to_string());
        let acts = match statement {
            Stmt::Expr(Expr::Assign(_) | Expr::MethodCall(_) | Expr::Call(_) | Expr::Try(_), Some(_)) => true,
            Stmt::Expr(Expr::Binary(binary), Some(_)) => is_assignment(&binary.op),
            _ => false,
        };
        visit_mut::visit_stmt_mut(self, statement);
        if acts && let Some(chosen) = self.offer(span, &format!("delete {text}")) {
            *statement = parse_quote!(if !#chosen { #statement });
        }
    }

    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        let (span, text) = (expression.span(), expression.to_token_stream().to_string());
        match expression {
            Expr::Lit(_) => self.literal(expression, &text, span),
            Expr::Binary(binary) if is_assignment(&binary.op) => self.assignment(expression, &text, span),
            // `let` is no operand of another operator.
            Expr::Binary(_) if text.contains("let ") => visit_mut::visit_expr_mut(self, expression),
            Expr::Binary(binary) if matches!(binary.op, BinOp::And(_) | BinOp::Or(_)) => {
                self.lazy(expression, &text, span)
            }
            Expr::Binary(_) => self.binary(expression, &text, span),
            Expr::Unary(unary) => {
                self.visit_expr_mut(&mut unary.expr);
                if matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) {
                    let (operator, operand) = (unary.op, &unary.expr);
                    if let Some(chosen) = self.offer(span, &format!("delete the sign of {text}")) {
                        *expression = parse_quote!((match #operand {
                            operand => if #chosen { operand } else { #operator operand }
                        }));
                    }
                }
            }
            Expr::MethodCall(_) => self.method(expression, &text),
            Expr::Match(choice) => self.arms(choice),
            Expr::If(choice) => {
                self.condition(&mut choice.cond);
                self.visit_block_mut(&mut choice.then_branch);
                if let Some((_, otherwise)) = &mut choice.else_branch {
                    self.visit_expr_mut(otherwise);
                }
            }
            _ => visit_mut::visit_expr_mut(self, expression),
        }
    }
}

fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let text = attribute.meta.to_token_stream().to_string().replace(' ', "");
        text == "test" || text == "cfg(test)"
    })
}

fn is_assignment(operator: &BinOp) -> bool {
    let name = operator.to_token_stream().to_string();
    name.len() > 1 && name.ends_with('=') && !["==", "!=", "<=", ">="].contains(&name.as_str())
}

#[cfg(test)]
mod tests;
