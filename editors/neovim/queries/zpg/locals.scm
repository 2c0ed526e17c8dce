(scene) @local.scope
(record id: (id) @local.definition)
(reference) @local.reference
