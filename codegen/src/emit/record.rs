//! The records of a model: `Parameters`, `State` and `Outputs`.

use super::number::whole;
use super::scope::Scope;
use super::scope::components;
use super::scope::identifier;
use crate::model::Model;
use crate::model::Shape;
use crate::model::Variable;
use proc_macro2::Ident;
use proc_macro2::TokenStream;
use quote::ToTokens;
use quote::quote;

/// A struct of scalars, vectors and matrices.
pub(super) struct Record<'a> {
    pub(super) name: Ident,
    fields: Vec<(Ident, &'a Variable)>,
    doc: &'static str,
}

impl<'a> Record<'a> {
    /// `Parameters`
    pub(super) fn parameters(model: &'a Model) -> Self {
        let variables = model.parameters.iter().map(|p| &p.variable);
        Self::new("Parameters", "The parameters.", variables)
    }

    /// `State`
    pub(super) fn state(model: &'a Model) -> Self {
        let variables = model.states.iter().map(|s| &s.variable);
        Self::new("State", "The state.", variables)
    }

    /// `Outputs`
    pub(super) fn outputs(model: &'a Model) -> Self {
        let variables = model.outputs.iter().map(|o| &o.variable);
        Self::new("Outputs", "The invariants and observables.", variables)
    }

    fn new(name: &str, doc: &'static str, variables: impl Iterator<Item = &'a Variable>) -> Self {
        let mut scope = Scope::fields();
        Self {
            name: identifier(name),
            fields: variables.map(|v| (scope.claim(&v.name.ascii), v)).collect(),
            doc,
        }
    }

    /// Number of scalars.
    pub(super) fn len(&self) -> usize {
        self.fields.iter().map(|f| f.1.shape.len()).sum()
    }

    /// The struct and its `Record` implementation.
    pub(super) fn declare(&self) -> TokenStream {
        let Self { name, doc, .. } = self;
        let doc = format!(" {doc}");
        let fields = self.fields.iter().map(|(field, variable)| {
            let doc = field_doc(variable);
            let ty = nested_type(variable.shape);
            quote!(#(#[doc = #doc])* pub #field: #ty)
        });
        // A record without fields still has its type parameter.
        let marker = self
            .fields
            .is_empty()
            .then(|| quote!(scalar: ::core::marker::PhantomData<T>));
        let fields = fields.chain(marker);
        let conversions = self.conversions();
        quote! {
            #[doc = #doc]
            #[allow(non_snake_case, reason = "names as in the model")]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct #name<T = f64> { #(#fields),* }

            #conversions
        }
    }

    fn conversions(&self) -> TokenStream {
        let name = &self.name;
        let n = whole(self.len());
        let mut scope = Scope::variables();
        let wishes = self
            .fields
            .iter()
            .flat_map(|(_, v)| components(&v.name.ascii, v.shape));
        let flat: Vec<Ident> = wishes.map(|wish| scope.claim(&wish)).collect();
        let built = self.build(&quote!(Self), |i| flat[i].to_token_stream());
        let unpacked = self.pattern(&quote!(Self), |i| Some(flat[i].to_token_stream()));
        let unpack = unpacked.map(|pattern| quote!(let #pattern = *self;));
        quote! {
            #[allow(non_snake_case, reason = "names as in the model")]
            impl<T: ::core::marker::Copy> ::residua::Record<T> for #name<T> {
                type Array = [T; #n];

                fn from_array([#(#flat),*]: [T; #n]) -> Self {
                    #built
                }

                fn to_array(&self) -> [T; #n] {
                    #unpack
                    [#(#flat),*]
                }
            }
        }
    }

    /// `path { m: …, rho: […, …, …] }`
    pub(super) fn build(
        &self,
        path: &TokenStream,
        component: impl Fn(usize) -> TokenStream,
    ) -> TokenStream {
        let mut offset = 0;
        let fields = self.fields.iter().map(|(field, variable)| {
            let components = (offset..offset + variable.shape.len()).map(&component);
            offset += variable.shape.len();
            member(field, nested(variable.shape, components.collect()))
        });
        let marker = self
            .fields
            .is_empty()
            .then(|| quote!(scalar: ::core::marker::PhantomData));
        let fields = fields.chain(marker);
        quote!(#path { #(#fields),* })
    }

    /// `path { m, rho: [rho_x, _, rho_z], .. }` with what `component` wants, if it wants anything.
    pub(super) fn pattern(
        &self,
        path: &TokenStream,
        component: impl Fn(usize) -> Option<TokenStream>,
    ) -> Option<TokenStream> {
        let mut offset = 0;
        let mut fields = Vec::new();
        for (field, variable) in &self.fields {
            let components = offset..offset + variable.shape.len();
            offset = components.end;
            let wanted: Vec<_> = components.map(&component).collect();
            if wanted.iter().any(Option::is_some) {
                let wanted = wanted.into_iter().map(|w| w.unwrap_or(quote!(_)));
                fields.push(member(field, nested(variable.shape, wanted.collect())));
            }
        }
        let rest = (fields.len() < self.fields.len()).then(|| quote!(..));
        (!fields.is_empty()).then(|| {
            let fields = fields.into_iter().chain(rest);
            quote!(#path { #(#fields),* })
        })
    }
}

/// `name: value`, or `name` for a variable of that name.
pub(super) fn member(name: &Ident, value: TokenStream) -> TokenStream {
    if *name == value.to_string() {
        value
    } else {
        quote!(#name: #value)
    }
}

/// Components as a scalar, a vector or a matrix of rows.
fn nested(shape: Shape, components: Vec<TokenStream>) -> TokenStream {
    if shape.is_scalar() {
        quote!(#(#components)*)
    } else if shape.cols == 1 {
        quote!([#(#components),*])
    } else {
        let rows = components.chunks(shape.cols).map(|row| quote!([#(#row),*]));
        quote!([#(#rows),*])
    }
}

fn nested_type(shape: Shape) -> TokenStream {
    let (rows, cols) = (whole(shape.rows), whole(shape.cols));
    if shape.is_scalar() {
        quote!(T)
    } else if shape.cols == 1 {
        quote!([T; #rows])
    } else {
        quote!([[T; #cols]; #rows])
    }
}

/// "`ω` in `1/s`: angular velocity", and what the file says in further lines.
fn field_doc(variable: &Variable) -> Vec<String> {
    let unit = &variable.symbols;
    let mut first = format!(" `{}`", variable.name.display);
    if unit != "1" {
        first.push_str(&format!(" in `{unit}`"));
    }
    let mut lines = variable.doc.iter().map(|line| line.trim());
    if let Some(line) = lines.next() {
        first.push_str(&format!(": {line}"));
    }
    std::iter::once(first)
        .chain(lines.map(|line| format!(" {line}")))
        .collect()
}
