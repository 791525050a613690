//! The structures of a Parquet file: the numbers and the types of their fields.
//!
//! All fields are listed that the library takes by their numbers. It skips others by the type that the file
//! states.
//!
//! Apache Parquet, *parquet.thrift*.

use super::thrift;
use super::thrift::Kind::{self, List, Plain, Struct, Truth};

const BYTE: Kind = Plain(thrift::BYTE);
const I16: Kind = Plain(thrift::I16);
const I32: Kind = Plain(thrift::I32);
const I64: Kind = Plain(thrift::I64);
const DOUBLE: Kind = Plain(thrift::DOUBLE);
const BINARY: Kind = Plain(thrift::BINARY);
const EMPTY: Kind = Struct(&[]);

pub(super) const FILE_METADATA: Kind = Struct(&[
    (1, I32),
    (2, List(&SCHEMA_ELEMENT)),
    (3, I64),
    (4, List(&ROW_GROUP)),
    (5, List(&KEY_VALUE)),
    (6, BINARY),
    (7, List(&COLUMN_ORDER)),
]);

const SCHEMA_ELEMENT: Kind = Struct(&[
    (1, I32),
    (2, I32),
    (3, I32),
    (4, BINARY),
    (5, I32),
    (6, I32),
    (7, I32),
    (8, I32),
    (9, I32),
    (10, LOGICAL_TYPE),
]);

const LOGICAL_TYPE: Kind = Struct(&[
    (1, EMPTY),
    (2, EMPTY),
    (3, EMPTY),
    (4, EMPTY),
    (5, Struct(&[(1, I32), (2, I32)])),
    (6, EMPTY),
    (7, TIME),
    (8, TIME),
    (10, Struct(&[(1, BYTE), (2, Truth)])),
    (11, EMPTY),
    (12, EMPTY),
    (13, EMPTY),
    (14, EMPTY),
    (15, EMPTY),
    (16, Struct(&[(1, BYTE)])),
    (17, Struct(&[(1, BINARY)])),
    (18, Struct(&[(1, BINARY), (2, I32)])),
    (19, EMPTY),
]);

const TIME: Kind = Struct(&[(1, Truth), (2, Struct(&[(1, EMPTY), (2, EMPTY), (3, EMPTY)]))]);
const COLUMN_ORDER: Kind = Struct(&[(1, EMPTY), (2, EMPTY), (3, EMPTY)]);
const KEY_VALUE: Kind = Struct(&[(1, BINARY), (2, BINARY)]);

const ROW_GROUP: Kind = Struct(&[
    (1, List(&COLUMN_CHUNK)),
    (2, I64),
    (3, I64),
    (4, List(&SORTING_COLUMN)),
    (5, I64),
    (6, I64),
    (7, I16),
]);

const SORTING_COLUMN: Kind = Struct(&[(1, I32), (2, Truth), (3, Truth)]);

const COLUMN_CHUNK: Kind = Struct(&[
    (1, BINARY),
    (2, I64),
    (3, COLUMN_METADATA),
    (4, I64),
    (5, I32),
    (6, I64),
    (7, I32),
]);

const COLUMN_METADATA: Kind = Struct(&[
    (1, I32),
    (2, List(&I32)),
    (3, List(&BINARY)),
    (4, I32),
    (5, I64),
    (6, I64),
    (7, I64),
    (8, List(&KEY_VALUE)),
    (9, I64),
    (10, I64),
    (11, I64),
    (12, STATISTICS),
    (13, List(&Struct(&[(1, I32), (2, I32), (3, I32)]))),
    (14, I64),
    (15, I32),
    (16, Struct(&[(1, I64), (2, List(&I64)), (3, List(&I64))])),
    (17, Struct(&[(1, BOX), (2, List(&I32))])),
]);

const STATISTICS: Kind = Struct(&[
    (1, BINARY),
    (2, BINARY),
    (3, I64),
    (4, I64),
    (5, BINARY),
    (6, BINARY),
    (7, Truth),
    (8, Truth),
    (9, I64),
]);

const BOX: Kind = Struct(&[
    (1, DOUBLE),
    (2, DOUBLE),
    (3, DOUBLE),
    (4, DOUBLE),
    (5, DOUBLE),
    (6, DOUBLE),
    (7, DOUBLE),
    (8, DOUBLE),
]);

pub(super) const PAGE_HEADER: Kind = Struct(&[
    (1, I32),
    (2, I32),
    (3, I32),
    (4, I32),
    (
        5,
        Struct(&[(1, I32), (2, I32), (3, I32), (4, I32), (5, STATISTICS)]),
    ),
    (6, EMPTY),
    (7, Struct(&[(1, I32), (2, I32), (3, Truth)])),
    (8, DATA_PAGE_V2),
]);

const DATA_PAGE_V2: Kind = Struct(&[
    (1, I32),
    (2, I32),
    (3, I32),
    (4, I32),
    (5, I32),
    (6, I32),
    (7, Truth),
    (8, STATISTICS),
]);
