//! The structures of a Parquet file: the types of their fields, in the order of their numbers, from 1.
//!
//! All fields are listed that the library takes by their numbers. It skips others by the type that the file
//! states.
//!
//! Apache Parquet, *parquet.thrift*.

use super::thrift;
use super::thrift::Kind::{self, List, Other, Plain, Struct, Truth};

const BYTE: Kind = Plain(thrift::BYTE);
const I16: Kind = Plain(thrift::I16);
const I32: Kind = Plain(thrift::I32);
const I64: Kind = Plain(thrift::I64);
const DOUBLE: Kind = Plain(thrift::DOUBLE);
const BINARY: Kind = Plain(thrift::BINARY);
const EMPTY: Kind = Struct(&[]);

pub(super) const FILE_METADATA: Kind = Struct(&[
    I32,
    List(&SCHEMA_ELEMENT),
    I64,
    List(&ROW_GROUP),
    List(&KEY_VALUE),
    BINARY,
    List(&COLUMN_ORDER),
]);

const SCHEMA_ELEMENT: Kind = Struct(&[I32, I32, I32, BINARY, I32, I32, I32, I32, I32, LOGICAL_TYPE]);

const LOGICAL_TYPE: Kind = Struct(&[
    EMPTY,
    EMPTY,
    EMPTY,
    EMPTY,
    Struct(&[I32, I32]),
    EMPTY,
    TIME,
    TIME,
    Other,
    Struct(&[BYTE, Truth]),
    EMPTY,
    EMPTY,
    EMPTY,
    EMPTY,
    EMPTY,
    Struct(&[BYTE]),
    Struct(&[BINARY]),
    Struct(&[BINARY, I32]),
    EMPTY,
]);

const TIME: Kind = Struct(&[Truth, Struct(&[EMPTY, EMPTY, EMPTY])]);
const COLUMN_ORDER: Kind = Struct(&[EMPTY, EMPTY, EMPTY]);
const KEY_VALUE: Kind = Struct(&[BINARY, BINARY]);

const ROW_GROUP: Kind = Struct(&[
    List(&COLUMN_CHUNK),
    I64,
    I64,
    List(&SORTING_COLUMN),
    I64,
    I64,
    I16,
]);

const SORTING_COLUMN: Kind = Struct(&[I32, Truth, Truth]);

const COLUMN_CHUNK: Kind = Struct(&[BINARY, I64, COLUMN_METADATA, I64, I32, I64, I32]);

const COLUMN_METADATA: Kind = Struct(&[
    I32,
    List(&I32),
    List(&BINARY),
    I32,
    I64,
    I64,
    I64,
    List(&KEY_VALUE),
    I64,
    I64,
    I64,
    STATISTICS,
    List(&Struct(&[I32, I32, I32])),
    I64,
    I32,
    Struct(&[I64, List(&I64), List(&I64)]),
    Struct(&[BOX, List(&I32)]),
]);

const STATISTICS: Kind = Struct(&[BINARY, BINARY, I64, I64, BINARY, BINARY, Truth, Truth, I64]);

const BOX: Kind = Struct(&[DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE]);

pub(super) const PAGE_HEADER: Kind = Struct(&[
    I32,
    I32,
    I32,
    I32,
    Struct(&[I32, I32, I32, I32, STATISTICS]),
    EMPTY,
    Struct(&[I32, I32, Truth]),
    DATA_PAGE_V2,
]);

const DATA_PAGE_V2: Kind = Struct(&[I32, I32, I32, I32, I32, I32, Truth, STATISTICS]);
