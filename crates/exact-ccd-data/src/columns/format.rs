//! The structures of a Parquet file: the types of their fields, in the order of their numbers, from 1.
//!
//! All fields are listed that the library takes by their numbers. It skips others by the type that the file
//! states.
//!
//! Apache Parquet, *parquet.thrift*.

use super::thrift;
use super::thrift::ValueType::{self, List, Other, Plain, Struct, Truth};

const BYTE: ValueType = Plain(thrift::BYTE);
const I16: ValueType = Plain(thrift::I16);
const I32: ValueType = Plain(thrift::I32);
const I64: ValueType = Plain(thrift::I64);
const DOUBLE: ValueType = Plain(thrift::DOUBLE);
const BINARY: ValueType = Plain(thrift::BINARY);
const EMPTY: ValueType = Struct(&[]);

pub(super) const FILE_METADATA: ValueType = Struct(&[
    I32,
    List(&SCHEMA_ELEMENT),
    I64,
    List(&ROW_GROUP),
    List(&KEY_VALUE),
    BINARY,
    List(&COLUMN_ORDER),
]);

const SCHEMA_ELEMENT: ValueType = Struct(&[I32, I32, I32, BINARY, I32, I32, I32, I32, I32, LOGICAL_TYPE]);

const LOGICAL_TYPE: ValueType = Struct(&[
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

const TIME: ValueType = Struct(&[Truth, Struct(&[EMPTY, EMPTY, EMPTY])]);
const COLUMN_ORDER: ValueType = Struct(&[EMPTY, EMPTY, EMPTY]);
const KEY_VALUE: ValueType = Struct(&[BINARY, BINARY]);

const ROW_GROUP: ValueType = Struct(&[
    List(&COLUMN_CHUNK),
    I64,
    I64,
    List(&SORTING_COLUMN),
    I64,
    I64,
    I16,
]);

const SORTING_COLUMN: ValueType = Struct(&[I32, Truth, Truth]);

const COLUMN_CHUNK: ValueType = Struct(&[BINARY, I64, COLUMN_METADATA, I64, I32, I64, I32]);

const COLUMN_METADATA: ValueType = Struct(&[
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

const STATISTICS: ValueType = Struct(&[BINARY, BINARY, I64, I64, BINARY, BINARY, Truth, Truth, I64]);

const BOX: ValueType = Struct(&[DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE, DOUBLE]);

pub(super) const PAGE_HEADER: ValueType = Struct(&[
    I32,
    I32,
    I32,
    I32,
    Struct(&[I32, I32, I32, I32, STATISTICS]),
    EMPTY,
    Struct(&[I32, I32, Truth]),
    DATA_PAGE_V2,
]);

const DATA_PAGE_V2: ValueType = Struct(&[I32, I32, I32, I32, I32, I32, Truth, STATISTICS]);
