//! A check of JSON against the part of JSON Schema that `docs/reports.schema.json` uses.

use std::path::Path;

use serde_json::{Map, Value};

/// The schema of the reports.
pub(crate) struct Schema(Value);

impl Schema {
    pub(crate) fn of_reports() -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reports.schema.json");
        Self(serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap())
    }

    /// Checks a value against a definition.
    #[track_caller]
    pub(crate) fn assert(&self, definition: &str, value: &Value) {
        if let Err(error) = self.check(&self.0["$defs"][definition], value) {
            panic!("{definition}{error}\n{value}");
        }
    }

    fn check(&self, schema: &Value, value: &Value) -> Result<(), String> {
        let schema = schema.as_object().unwrap();
        for (keyword, content) in schema {
            match keyword.as_str() {
                "$ref" => {
                    let name = content.as_str().unwrap().strip_prefix("#/$defs/").unwrap();
                    self.check(self.0["$defs"].get(name).unwrap(), value)?;
                }
                "anyOf" => {
                    let tried: Vec<_> = list(content)
                        .iter()
                        .map(|schema| self.check(schema, value))
                        .collect();
                    if tried.iter().all(Result::is_err) {
                        return Err(format!(" is none of these: {tried:?}"));
                    }
                }
                "type" => {
                    let is = |name: &Value| is_of_type(value, name.as_str().unwrap());
                    expect(
                        if content.is_array() {
                            list(content).iter().any(is)
                        } else {
                            is(content)
                        },
                        content,
                    )?;
                }
                "enum" => expect(list(content).contains(value), content)?,
                "minimum" => expect(
                    value.as_f64().is_none_or(|x| x >= content.as_f64().unwrap()),
                    content,
                )?,
                "maximum" => expect(
                    value.as_f64().is_none_or(|x| x <= content.as_f64().unwrap()),
                    content,
                )?,
                "minItems" => expect(
                    length(value).is_none_or(|n| n >= content.as_u64().unwrap()),
                    content,
                )?,
                "maxItems" => expect(
                    length(value).is_none_or(|n| n <= content.as_u64().unwrap()),
                    content,
                )?,
                "items" => {
                    for (index, item) in value.as_array().into_iter().flatten().enumerate() {
                        self.check(content, item)
                            .map_err(|error| format!("[{index}]{error}"))?;
                    }
                }
                "properties" => {
                    for (name, value) in value.as_object().into_iter().flatten() {
                        if let Some(schema) = content.get(name) {
                            self.check(schema, value)
                                .map_err(|error| format!(".{name}{error}"))?;
                        }
                    }
                }
                "required" => {
                    let is_there = |object: &Map<_, _>| {
                        list(content)
                            .iter()
                            .all(|name| object.contains_key(name.as_str().unwrap()))
                    };
                    expect(value.as_object().is_none_or(is_there), content)?;
                }
                "additionalProperties" => {
                    assert_eq!(content, &Value::Bool(false));
                    let known = schema["properties"].as_object().unwrap();
                    let other = value
                        .as_object()
                        .into_iter()
                        .flatten()
                        .find(|(name, _)| !known.contains_key(*name));
                    if let Some((name, _)) = other {
                        return Err(format!(" has the property {name}, which is not in the schema"));
                    }
                }
                other => panic!("the check does not know the keyword {other}"),
            }
        }
        Ok(())
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn length(value: &Value) -> Option<u64> {
    value.as_array().map(|items| items.len() as u64)
}

fn expect(holds: bool, content: &Value) -> Result<(), String> {
    if holds {
        Ok(())
    } else {
        Err(format!(": expected {content}"))
    }
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        other => panic!("there is no type {other}"),
    }
}

#[test]
fn the_check_finds_faults() {
    let schema = Schema::of_reports();
    let good = serde_json::json!({"lower": 0.0, "upper": 1.0});
    assert_eq!(schema.check(&schema.0["$defs"]["bounds"], &good), Ok(()));
    for bad in [
        serde_json::json!({"lower": 0.0}),
        serde_json::json!({"lower": 0.0, "upper": "1"}),
        serde_json::json!({"lower": -1.0, "upper": 1.0}),
        serde_json::json!({"lower": 0.0, "upper": 1.0, "middle": 0.5}),
        serde_json::json!([0.0, 1.0]),
    ] {
        assert!(schema.check(&schema.0["$defs"]["bounds"], &bad).is_err(), "{bad}");
    }
    assert!(
        schema
            .check(&schema.0["$defs"]["vector"], &serde_json::json!([0.0, 1.0]))
            .is_err()
    );
}
