//! The protocol's own description of its messages, and whether a message keeps to it.
//!
//! `protocol.json` is the metamodel of the protocol (3.18) as it lies in the `lsprotocol` package of Microsoft, without
//! its documentation; its licence lies beside it.

use serde_json::Value;

/// The description.
pub struct Model(Value);

/// What a message is not.
pub type Wrong = String;

impl Model {
    pub fn read() -> Model {
        Model(serde_json::from_str(include_str!("protocol.json")).unwrap())
    }

    fn named(&self, list: &str, key: &str, name: &str) -> Option<&Value> {
        self.0[list]
            .as_array()
            .unwrap()
            .iter()
            .find(|v| v[key] == name)
    }

    /// Checks a request or a notification that a server sends.
    pub fn check_call(&self, method: &str, params: &Value, is_request: bool) -> Result<(), Wrong> {
        let list = if is_request {
            "requests"
        } else {
            "notifications"
        };
        let call = self
            .named(list, "method", method)
            .ok_or(format!("unknown method {method}"))?;
        if call["messageDirection"] == "clientToServer" {
            return Err(format!("{method} is for clients"));
        }
        match call.get("params") {
            Some(ty) => self.check(ty, params, method),
            None if params.is_null() => Ok(()),
            None => Err(format!("{method} has no parameters")),
        }
    }

    /// Checks the parameters that a test sends.
    pub fn check_asked(&self, method: &str, params: &Value) -> Result<(), Wrong> {
        let of = |list| self.named(list, "method", method);
        match of("requests")
            .or_else(|| of("notifications"))
            .and_then(|call| call.get("params"))
        {
            Some(ty) => self.check(ty, params, method),
            None => Ok(()),
        }
    }

    /// Checks the result of a request.
    pub fn check_result(&self, method: &str, result: &Value) -> Result<(), Wrong> {
        match self.named("requests", "method", method) {
            Some(request) => self.check(&request["result"], result, method),
            None => Err(format!("unknown method {method}")),
        }
    }

    fn check(&self, ty: &Value, value: &Value, at: &str) -> Result<(), Wrong> {
        let wrong = |what: &str| {
            let text: String = value.to_string().chars().take(200).collect();
            Err(format!("{at}: {text} is no {what}"))
        };
        match ty["kind"].as_str().unwrap() {
            "base" => {
                let name = ty["name"].as_str().unwrap();
                let right = match name {
                    "URI" | "DocumentUri" | "string" | "RegExp" => value.is_string(),
                    "integer" => value.as_i64().is_some_and(|n| i32::try_from(n).is_ok()),
                    "uinteger" => value.as_u64().is_some_and(|n| n < 1 << 31),
                    "decimal" => value.is_number(),
                    "boolean" => value.is_boolean(),
                    "null" => value.is_null(),
                    other => panic!("{other}"),
                };
                if right { Ok(()) } else { wrong(name) }
            }
            "reference" => self.check_named(ty["name"].as_str().unwrap(), value, at),
            "array" => match value.as_array() {
                None => wrong("array"),
                Some(all) => (all.iter().enumerate())
                    .try_for_each(|(i, v)| self.check(&ty["element"], v, &format!("{at}[{i}]"))),
            },
            "map" => match value.as_object() {
                None => wrong("map"),
                Some(all) => (all.iter())
                    .try_for_each(|(k, v)| self.check(&ty["value"], v, &format!("{at}.{k}"))),
            },
            "or" => {
                let tried = ty["items"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(|t| self.check(t, value, at));
                let mut failures = Vec::new();
                for result in tried {
                    match result {
                        Ok(()) => return Ok(()),
                        Err(why) => failures.push(why),
                    }
                }
                Err(failures.join("; "))
            }
            "tuple" => {
                let (types, all) = (ty["items"].as_array().unwrap(), value.as_array());
                match all.filter(|all| all.len() == types.len()) {
                    None => wrong("tuple"),
                    Some(all) => {
                        (types.iter().zip(all)).try_for_each(|(t, v)| self.check(t, v, at))
                    }
                }
            }
            "stringLiteral" if *value == ty["value"] => Ok(()),
            "stringLiteral" => wrong(ty["value"].as_str().unwrap()),
            "literal" => {
                let all: Vec<&Value> = ty["value"]["properties"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .collect();
                self.check_properties(&all, value, at)
            }
            other => panic!("{other}"),
        }
    }

    fn check_named(&self, name: &str, value: &Value, at: &str) -> Result<(), Wrong> {
        if matches!(name, "LSPAny" | "LSPObject" | "LSPArray") {
            return Ok(());
        }
        if let Some(structure) = self.named("structures", "name", name) {
            let mut all = Vec::new();
            self.properties(structure, &mut all);
            return self.check_properties(&all, value, &format!("{at}:{name}"));
        }
        if let Some(kinds) = self.named("enumerations", "name", name) {
            self.check(&kinds["type"], value, at)?;
            let values = kinds["values"].as_array().unwrap();
            let is_known = values.iter().any(|v| v["value"] == *value);
            return match is_known || kinds["supportsCustomValues"] == true {
                true => Ok(()),
                false => Err(format!("{at}: {value} is no {name}")),
            };
        }
        let alias = self
            .named("typeAliases", "name", name)
            .unwrap_or_else(|| panic!("{name}"));
        self.check(&alias["type"], value, at)
    }

    fn properties<'a>(&'a self, structure: &'a Value, out: &mut Vec<&'a Value>) {
        for list in ["extends", "mixins"] {
            for base in structure[list].as_array().into_iter().flatten() {
                let name = base["name"].as_str().unwrap();
                self.properties(self.named("structures", "name", name).unwrap(), out);
            }
        }
        out.extend(structure["properties"].as_array().unwrap());
    }

    /// Properties that nobody knows are wrong, too.
    fn check_properties(&self, all: &[&Value], value: &Value, at: &str) -> Result<(), Wrong> {
        let Some(fields) = value.as_object() else {
            return Err(format!("{at}: {value} is no object"));
        };
        if let Some(name) = fields
            .keys()
            .find(|k| !all.iter().any(|p| p["name"] == **k))
        {
            return Err(format!("{at}: there is no property {name}"));
        }
        all.iter().try_for_each(|property| {
            let name = property["name"].as_str().unwrap();
            match fields.get(name) {
                Some(value) => self.check(&property["type"], value, &format!("{at}.{name}")),
                None if property["optional"] == true => Ok(()),
                None => Err(format!("{at}: {name} is missing")),
            }
        })
    }
}

/// Messages that are wrong in one thing each.
#[test]
fn what_is_wrong_is_told() {
    let model = Model::read();
    let zero = serde_json::json!({ "line": 0, "character": 0 });
    let good = serde_json::json!({
        "uri": "file:///a", "version": 1,
        "diagnostics": [{ "range": { "start": zero, "end": zero }, "message": "a", "severity": 1 }],
    });
    let method = "textDocument/publishDiagnostics";
    model.check_call(method, &good, false).unwrap();
    let broken = |change: &dyn Fn(&mut Value)| {
        let mut params = good.clone();
        change(&mut params);
        model.check_call(method, &params, false).unwrap_err()
    };
    assert!(broken(&|p| p["uris"] = 1.into()).contains("no property uris"));
    assert!(broken(&|p| p["diagnostics"][0]["severity"] = 9.into()).contains("severity"));
    assert!(broken(&|p| p["version"] = 1.5.into()).contains("integer"));
    let line = "/diagnostics/0/range/start/line";
    assert!(broken(&|p| *p.pointer_mut(line).unwrap() = (-1).into()).contains("uinteger"));
    assert!(broken(&|p| drop(p.as_object_mut().unwrap().remove("uri"))).contains("missing"));
    assert!(model.check_call(method, &good, true).is_err());
    assert!(
        model
            .check_call("textDocument/didOpen", &good, false)
            .is_err()
    );
}
