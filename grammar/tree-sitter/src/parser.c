#include "tree_sitter/parser.h"

#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif

#define LANGUAGE_VERSION 14
#define STATE_COUNT 10
#define LARGE_STATE_COUNT 7
#define SYMBOL_COUNT 16
#define ALIAS_COUNT 0
#define TOKEN_COUNT 12
#define EXTERNAL_TOKEN_COUNT 10
#define FIELD_COUNT 2
#define MAX_ALIAS_SEQUENCE_LENGTH 3
#define PRODUCTION_ID_COUNT 3

enum ts_symbol_identifiers {
  sym_separator = 1,
  sym_comment = 2,
  sym_void = 3,
  sym_id = 4,
  sym_type = 5,
  sym_number = 6,
  sym_reference = 7,
  sym_colour = 8,
  sym_angle = 9,
  sym_file = 10,
  sym_word = 11,
  sym_scene = 12,
  sym_record = 13,
  aux_sym_scene_repeat1 = 14,
  aux_sym_record_repeat1 = 15,
};

static const char * const ts_symbol_names[] = {
  [ts_builtin_sym_end] = "end",
  [sym_separator] = "separator",
  [sym_comment] = "comment",
  [sym_void] = "void",
  [sym_id] = "id",
  [sym_type] = "type",
  [sym_number] = "number",
  [sym_reference] = "reference",
  [sym_colour] = "colour",
  [sym_angle] = "angle",
  [sym_file] = "file",
  [sym_word] = "word",
  [sym_scene] = "scene",
  [sym_record] = "record",
  [aux_sym_scene_repeat1] = "scene_repeat1",
  [aux_sym_record_repeat1] = "record_repeat1",
};

static const TSSymbol ts_symbol_map[] = {
  [ts_builtin_sym_end] = ts_builtin_sym_end,
  [sym_separator] = sym_separator,
  [sym_comment] = sym_comment,
  [sym_void] = sym_void,
  [sym_id] = sym_id,
  [sym_type] = sym_type,
  [sym_number] = sym_number,
  [sym_reference] = sym_reference,
  [sym_colour] = sym_colour,
  [sym_angle] = sym_angle,
  [sym_file] = sym_file,
  [sym_word] = sym_word,
  [sym_scene] = sym_scene,
  [sym_record] = sym_record,
  [aux_sym_scene_repeat1] = aux_sym_scene_repeat1,
  [aux_sym_record_repeat1] = aux_sym_record_repeat1,
};

static const TSSymbolMetadata ts_symbol_metadata[] = {
  [ts_builtin_sym_end] = {
    .visible = false,
    .named = true,
  },
  [sym_separator] = {
    .visible = true,
    .named = true,
  },
  [sym_comment] = {
    .visible = true,
    .named = true,
  },
  [sym_void] = {
    .visible = true,
    .named = true,
  },
  [sym_id] = {
    .visible = true,
    .named = true,
  },
  [sym_type] = {
    .visible = true,
    .named = true,
  },
  [sym_number] = {
    .visible = true,
    .named = true,
  },
  [sym_reference] = {
    .visible = true,
    .named = true,
  },
  [sym_colour] = {
    .visible = true,
    .named = true,
  },
  [sym_angle] = {
    .visible = true,
    .named = true,
  },
  [sym_file] = {
    .visible = true,
    .named = true,
  },
  [sym_word] = {
    .visible = true,
    .named = true,
  },
  [sym_scene] = {
    .visible = true,
    .named = true,
  },
  [sym_record] = {
    .visible = true,
    .named = true,
  },
  [aux_sym_scene_repeat1] = {
    .visible = false,
    .named = false,
  },
  [aux_sym_record_repeat1] = {
    .visible = false,
    .named = false,
  },
};

enum ts_field_identifiers {
  field_id = 1,
  field_type = 2,
};

static const char * const ts_field_names[] = {
  [0] = NULL,
  [field_id] = "id",
  [field_type] = "type",
};

static const TSFieldMapSlice ts_field_map_slices[PRODUCTION_ID_COUNT] = {
  [1] = {.index = 0, .length = 1},
  [2] = {.index = 1, .length = 2},
};

static const TSFieldMapEntry ts_field_map_entries[] = {
  [0] =
    {field_id, 0},
  [1] =
    {field_id, 0},
    {field_type, 1},
};

static const TSSymbol ts_alias_sequences[PRODUCTION_ID_COUNT][MAX_ALIAS_SEQUENCE_LENGTH] = {
  [0] = {0},
};

static const uint16_t ts_non_terminal_alias_map[] = {
  0,
};

static const TSStateId ts_primary_state_ids[STATE_COUNT] = {
  [0] = 0,
  [1] = 1,
  [2] = 2,
  [3] = 3,
  [4] = 4,
  [5] = 5,
  [6] = 6,
  [7] = 7,
  [8] = 8,
  [9] = 9,
};

static TSCharacterRange sym_separator_character_set_1[] = {
  {'(', ')'}, {',', ','}, {';', '<'}, {'>', '>'}, {'{', '{'}, {'}', '}'}, {0x2039, 0x203a}, {0x27e8, 0x27e9},
  {0x3008, 0x3009},
};

static bool ts_lex(TSLexer *lexer, TSStateId state) {
  START_LEXER();
  eof = lexer->eof(lexer);
  switch (state) {
    case 0:
      if (eof) ADVANCE(1);
      if (('\t' <= lookahead && lookahead <= '\r') ||
          lookahead == ' ' ||
          lookahead == 0xfeff) SKIP(0);
      if (set_contains(sym_separator_character_set_1, 9, lookahead)) ADVANCE(2);
      END_STATE();
    case 1:
      ACCEPT_TOKEN(ts_builtin_sym_end);
      END_STATE();
    case 2:
      ACCEPT_TOKEN(sym_separator);
      END_STATE();
    default:
      return false;
  }
}

static const TSLexMode ts_lex_modes[STATE_COUNT] = {
  [0] = {.lex_state = 0, .external_lex_state = 1},
  [1] = {.lex_state = 0, .external_lex_state = 2},
  [2] = {.lex_state = 0, .external_lex_state = 1},
  [3] = {.lex_state = 0, .external_lex_state = 3},
  [4] = {.lex_state = 0, .external_lex_state = 3},
  [5] = {.lex_state = 0, .external_lex_state = 3},
  [6] = {.lex_state = 0, .external_lex_state = 3},
  [7] = {.lex_state = 0, .external_lex_state = 2},
  [8] = {.lex_state = 0, .external_lex_state = 2},
  [9] = {.lex_state = 0, .external_lex_state = 4},
};

static const uint16_t ts_parse_table[LARGE_STATE_COUNT][SYMBOL_COUNT] = {
  [0] = {
    [ts_builtin_sym_end] = ACTIONS(1),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(1),
    [sym_id] = ACTIONS(1),
    [sym_type] = ACTIONS(1),
    [sym_number] = ACTIONS(1),
    [sym_reference] = ACTIONS(1),
    [sym_colour] = ACTIONS(1),
    [sym_angle] = ACTIONS(1),
    [sym_file] = ACTIONS(1),
    [sym_word] = ACTIONS(1),
  },
  [1] = {
    [sym_scene] = STATE(9),
    [sym_record] = STATE(7),
    [aux_sym_scene_repeat1] = STATE(7),
    [ts_builtin_sym_end] = ACTIONS(5),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(7),
    [sym_id] = ACTIONS(9),
    [sym_word] = ACTIONS(7),
  },
  [2] = {
    [aux_sym_record_repeat1] = STATE(4),
    [ts_builtin_sym_end] = ACTIONS(11),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(11),
    [sym_id] = ACTIONS(11),
    [sym_type] = ACTIONS(13),
    [sym_number] = ACTIONS(15),
    [sym_reference] = ACTIONS(15),
    [sym_colour] = ACTIONS(15),
    [sym_angle] = ACTIONS(15),
    [sym_file] = ACTIONS(15),
    [sym_word] = ACTIONS(15),
  },
  [3] = {
    [aux_sym_record_repeat1] = STATE(5),
    [ts_builtin_sym_end] = ACTIONS(17),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(17),
    [sym_id] = ACTIONS(17),
    [sym_number] = ACTIONS(19),
    [sym_reference] = ACTIONS(19),
    [sym_colour] = ACTIONS(19),
    [sym_angle] = ACTIONS(19),
    [sym_file] = ACTIONS(19),
    [sym_word] = ACTIONS(19),
  },
  [4] = {
    [aux_sym_record_repeat1] = STATE(6),
    [ts_builtin_sym_end] = ACTIONS(21),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(21),
    [sym_id] = ACTIONS(21),
    [sym_number] = ACTIONS(23),
    [sym_reference] = ACTIONS(23),
    [sym_colour] = ACTIONS(23),
    [sym_angle] = ACTIONS(23),
    [sym_file] = ACTIONS(23),
    [sym_word] = ACTIONS(23),
  },
  [5] = {
    [aux_sym_record_repeat1] = STATE(6),
    [ts_builtin_sym_end] = ACTIONS(25),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(25),
    [sym_id] = ACTIONS(25),
    [sym_number] = ACTIONS(23),
    [sym_reference] = ACTIONS(23),
    [sym_colour] = ACTIONS(23),
    [sym_angle] = ACTIONS(23),
    [sym_file] = ACTIONS(23),
    [sym_word] = ACTIONS(23),
  },
  [6] = {
    [aux_sym_record_repeat1] = STATE(6),
    [ts_builtin_sym_end] = ACTIONS(27),
    [sym_separator] = ACTIONS(3),
    [sym_comment] = ACTIONS(3),
    [sym_void] = ACTIONS(27),
    [sym_id] = ACTIONS(27),
    [sym_number] = ACTIONS(29),
    [sym_reference] = ACTIONS(29),
    [sym_colour] = ACTIONS(29),
    [sym_angle] = ACTIONS(29),
    [sym_file] = ACTIONS(29),
    [sym_word] = ACTIONS(29),
  },
};

static const uint16_t ts_small_parse_table[] = {
  [0] = 5,
    ACTIONS(9), 1,
      sym_id,
    ACTIONS(32), 1,
      ts_builtin_sym_end,
    ACTIONS(3), 2,
      sym_comment,
      sym_separator,
    ACTIONS(34), 2,
      sym_void,
      sym_word,
    STATE(8), 2,
      sym_record,
      aux_sym_scene_repeat1,
  [19] = 5,
    ACTIONS(36), 1,
      ts_builtin_sym_end,
    ACTIONS(41), 1,
      sym_id,
    ACTIONS(3), 2,
      sym_comment,
      sym_separator,
    ACTIONS(38), 2,
      sym_void,
      sym_word,
    STATE(8), 2,
      sym_record,
      aux_sym_scene_repeat1,
  [38] = 2,
    ACTIONS(44), 1,
      ts_builtin_sym_end,
    ACTIONS(3), 2,
      sym_comment,
      sym_separator,
};

static const uint32_t ts_small_parse_table_map[] = {
  [SMALL_STATE(7)] = 0,
  [SMALL_STATE(8)] = 19,
  [SMALL_STATE(9)] = 38,
};

static const TSParseActionEntry ts_parse_actions[] = {
  [0] = {.entry = {.count = 0, .reusable = false}},
  [1] = {.entry = {.count = 1, .reusable = false}}, RECOVER(),
  [3] = {.entry = {.count = 1, .reusable = true}}, SHIFT_EXTRA(),
  [5] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_scene, 0, 0, 0),
  [7] = {.entry = {.count = 1, .reusable = true}}, SHIFT(7),
  [9] = {.entry = {.count = 1, .reusable = true}}, SHIFT(2),
  [11] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_record, 1, 0, 1),
  [13] = {.entry = {.count = 1, .reusable = true}}, SHIFT(3),
  [15] = {.entry = {.count = 1, .reusable = true}}, SHIFT(4),
  [17] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_record, 2, 0, 2),
  [19] = {.entry = {.count = 1, .reusable = true}}, SHIFT(5),
  [21] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_record, 2, 0, 1),
  [23] = {.entry = {.count = 1, .reusable = true}}, SHIFT(6),
  [25] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_record, 3, 0, 2),
  [27] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_record_repeat1, 2, 0, 0),
  [29] = {.entry = {.count = 2, .reusable = true}}, REDUCE(aux_sym_record_repeat1, 2, 0, 0), SHIFT_REPEAT(6),
  [32] = {.entry = {.count = 1, .reusable = true}}, REDUCE(sym_scene, 1, 0, 0),
  [34] = {.entry = {.count = 1, .reusable = true}}, SHIFT(8),
  [36] = {.entry = {.count = 1, .reusable = true}}, REDUCE(aux_sym_scene_repeat1, 2, 0, 0),
  [38] = {.entry = {.count = 2, .reusable = true}}, REDUCE(aux_sym_scene_repeat1, 2, 0, 0), SHIFT_REPEAT(8),
  [41] = {.entry = {.count = 2, .reusable = true}}, REDUCE(aux_sym_scene_repeat1, 2, 0, 0), SHIFT_REPEAT(2),
  [44] = {.entry = {.count = 1, .reusable = true}},  ACCEPT_INPUT(),
};

enum ts_external_scanner_symbol_identifiers {
  ts_external_token_comment = 0,
  ts_external_token_void = 1,
  ts_external_token_id = 2,
  ts_external_token_type = 3,
  ts_external_token_number = 4,
  ts_external_token_reference = 5,
  ts_external_token_colour = 6,
  ts_external_token_angle = 7,
  ts_external_token_file = 8,
  ts_external_token_word = 9,
};

static const TSSymbol ts_external_scanner_symbol_map[EXTERNAL_TOKEN_COUNT] = {
  [ts_external_token_comment] = sym_comment,
  [ts_external_token_void] = sym_void,
  [ts_external_token_id] = sym_id,
  [ts_external_token_type] = sym_type,
  [ts_external_token_number] = sym_number,
  [ts_external_token_reference] = sym_reference,
  [ts_external_token_colour] = sym_colour,
  [ts_external_token_angle] = sym_angle,
  [ts_external_token_file] = sym_file,
  [ts_external_token_word] = sym_word,
};

static const bool ts_external_scanner_states[5][EXTERNAL_TOKEN_COUNT] = {
  [1] = {
    [ts_external_token_comment] = true,
    [ts_external_token_void] = true,
    [ts_external_token_id] = true,
    [ts_external_token_type] = true,
    [ts_external_token_number] = true,
    [ts_external_token_reference] = true,
    [ts_external_token_colour] = true,
    [ts_external_token_angle] = true,
    [ts_external_token_file] = true,
    [ts_external_token_word] = true,
  },
  [2] = {
    [ts_external_token_comment] = true,
    [ts_external_token_void] = true,
    [ts_external_token_id] = true,
    [ts_external_token_word] = true,
  },
  [3] = {
    [ts_external_token_comment] = true,
    [ts_external_token_void] = true,
    [ts_external_token_id] = true,
    [ts_external_token_number] = true,
    [ts_external_token_reference] = true,
    [ts_external_token_colour] = true,
    [ts_external_token_angle] = true,
    [ts_external_token_file] = true,
    [ts_external_token_word] = true,
  },
  [4] = {
    [ts_external_token_comment] = true,
  },
};

#ifdef __cplusplus
extern "C" {
#endif
void *tree_sitter_zpg_external_scanner_create(void);
void tree_sitter_zpg_external_scanner_destroy(void *);
bool tree_sitter_zpg_external_scanner_scan(void *, TSLexer *, const bool *);
unsigned tree_sitter_zpg_external_scanner_serialize(void *, char *);
void tree_sitter_zpg_external_scanner_deserialize(void *, const char *, unsigned);

#ifdef TREE_SITTER_HIDE_SYMBOLS
#define TS_PUBLIC
#elif defined(_WIN32)
#define TS_PUBLIC __declspec(dllexport)
#else
#define TS_PUBLIC __attribute__((visibility("default")))
#endif

TS_PUBLIC const TSLanguage *tree_sitter_zpg(void) {
  static const TSLanguage language = {
    .version = LANGUAGE_VERSION,
    .symbol_count = SYMBOL_COUNT,
    .alias_count = ALIAS_COUNT,
    .token_count = TOKEN_COUNT,
    .external_token_count = EXTERNAL_TOKEN_COUNT,
    .state_count = STATE_COUNT,
    .large_state_count = LARGE_STATE_COUNT,
    .production_id_count = PRODUCTION_ID_COUNT,
    .field_count = FIELD_COUNT,
    .max_alias_sequence_length = MAX_ALIAS_SEQUENCE_LENGTH,
    .parse_table = &ts_parse_table[0][0],
    .small_parse_table = ts_small_parse_table,
    .small_parse_table_map = ts_small_parse_table_map,
    .parse_actions = ts_parse_actions,
    .symbol_names = ts_symbol_names,
    .field_names = ts_field_names,
    .field_map_slices = ts_field_map_slices,
    .field_map_entries = ts_field_map_entries,
    .symbol_metadata = ts_symbol_metadata,
    .public_symbol_map = ts_symbol_map,
    .alias_map = ts_non_terminal_alias_map,
    .alias_sequences = &ts_alias_sequences[0][0],
    .lex_modes = ts_lex_modes,
    .lex_fn = ts_lex,
    .external_scanner = {
      &ts_external_scanner_states[0][0],
      ts_external_scanner_symbol_map,
      tree_sitter_zpg_external_scanner_create,
      tree_sitter_zpg_external_scanner_destroy,
      tree_sitter_zpg_external_scanner_scan,
      tree_sitter_zpg_external_scanner_serialize,
      tree_sitter_zpg_external_scanner_deserialize,
    },
    .primary_state_ids = ts_primary_state_ids,
  };
  return &language;
}
#ifdef __cplusplus
}
#endif
