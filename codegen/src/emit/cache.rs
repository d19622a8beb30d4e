//! The caches of a solver or flow: private structs of what slower functions have computed.

use super::names::Names;
use super::number::whole;
use super::record::member;
use super::scope::identifier;
use crate::schedule::Schedule;
use crate::schedule::ValueId;
use proc_macro2::Ident;
use proc_macro2::TokenStream;
use quote::quote;

/// `Scene` or `Step` with its fields.
pub(super) struct Cache {
    name: Ident,
    fields: Vec<(ValueId, Ident)>,
}

impl Cache {
    /// A cache of `values`.
    pub(super) fn new(
        name: &str,
        values: &[ValueId],
        schedule: &Schedule,
        names: &mut Names,
    ) -> Self {
        Self {
            name: identifier(name),
            fields: values
                .iter()
                .map(|v| (*v, names.value(schedule, *v)))
                .collect(),
        }
    }

    /// The struct; the unit type if nothing is cached.
    pub(super) fn declare(&self, doc: &str) -> TokenStream {
        let name = &self.name;
        let doc = format!(" {doc}");
        if self.fields.is_empty() {
            return quote!(#[doc = #doc] type #name = (););
        }
        let fields = self.fields.iter().map(|f| &f.1);
        quote! {
            #[doc = #doc]
            #[derive(Clone, Copy)]
            pub struct #name<T> { #(#fields: T),* }
        }
    }

    /// Its `Cache` implementation, by which lanes of trajectories keep it component by component: one line each, for
    /// loops over many are not unrolled.
    pub(super) fn components(&self) -> TokenStream {
        let name = &self.name;
        if self.fields.is_empty() {
            return TokenStream::new();
        }
        let n = whole(self.fields.len());
        let fields: Vec<_> = self.fields.iter().map(|f| &f.1).collect();
        let positions: Vec<_> = (0..self.fields.len()).map(whole).collect();
        quote! {
            impl<T: ::core::marker::Copy> ::residua::Cache<T> for #name<T> {
                const LEN: usize = #n;

                #[inline(always)]
                fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
                    Self { #(#fields: from(#positions)),* }
                }

                fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
                    #(to(#positions, self.#fields);)*
                }
            }
        }
    }

    /// The type.
    pub(super) fn ty(&self) -> TokenStream {
        let name = &self.name;
        if self.fields.is_empty() {
            quote!(#name)
        } else {
            quote!(#name<T>)
        }
    }

    /// `Scene { … }` from the value of each field.
    pub(super) fn build(&self, values: Vec<TokenStream>) -> TokenStream {
        let name = &self.name;
        if self.fields.is_empty() {
            return TokenStream::new();
        }
        let fields = self
            .fields
            .iter()
            .zip(values)
            .map(|(f, value)| member(&f.1, value));
        quote!(#name { #(#fields),* })
    }

    /// `Scene { m, h_m_g_l, .. }` with what is read, if anything is.
    pub(super) fn pattern(&self, is_read: impl Fn(ValueId) -> bool) -> Option<TokenStream> {
        let name = &self.name;
        let read: Vec<_> = self
            .fields
            .iter()
            .filter(|f| is_read(f.0))
            .map(|f| &f.1)
            .collect();
        let rest = (read.len() < self.fields.len()).then(|| quote!(, ..));
        (!read.is_empty()).then(|| quote!(#name { #(#read),* #rest }))
    }
}
