// Tells IDs, types and parameters apart, by the number of parameters that each type has.
//
// A record that lacks numbers ends before a line that is a whole record by itself: a slip does not shift what follows.

#include "tree_sitter/alloc.h"
#include "tree_sitter/parser.h"

#include <string.h>

// In the order of `externals` in grammar.js.
enum TokenType { COMMENT, VOID, ID, TYPE, NUMBER, REFERENCE, COLOUR, ANGLE, FILE_NAME, WORD, SURPLUS };

struct RecordType {
  int32_t code;
  // A letter a parameter: n number, r reference, c colour, a angle, f file, k count.
  const char *params;
  // What follows as often as the count says, and then again.
  const char *groups[2];
  const char *optional;
};

#include "types.h"

#define TYPE_COUNT (int)(sizeof(RECORD_TYPES) / sizeof(RECORD_TYPES[0]))

// AT_REST: behind an unknown type, as far as the line goes.
enum Stage { AT_ID, AT_TYPE, AT_PARAMS, AT_REST };

struct State {
  uint8_t stage;
  // Whether a line break stands between the last token and here.
  uint8_t broken_line;
  int16_t type;
  // How many parameters have been read.
  uint32_t read;
  uint32_t count;
};

static const struct RecordType *find(int64_t code, int16_t *index) {
  for (int i = 0; i < TYPE_COUNT; i++) {
    if (RECORD_TYPES[i].code == code) {
      *index = (int16_t)i;
      return &RECORD_TYPES[i];
    }
  }
  return NULL;
}

static uint64_t required(const struct RecordType *type, uint64_t count) {
  return strlen(type->params) + count * (strlen(type->groups[0]) + strlen(type->groups[1]));
}

// What the parameter at a position is for; 0 behind the last one.
static char role(const struct RecordType *type, uint64_t count, uint64_t at) {
  uint64_t length = strlen(type->params);
  if (at < length) return type->params[at];
  at -= length;
  for (int i = 0; i < 2; i++) {
    uint64_t own = strlen(type->groups[i]);
    if (own > 0 && at < own * count) return type->groups[i][at % own];
    at -= own * count;
  }
  return at < strlen(type->optional) ? type->optional[at] : 0;
}

static bool is_separator(int32_t c) {
  for (size_t i = 0; i < sizeof SEPARATORS / sizeof *SEPARATORS; i++) {
    if (SEPARATORS[i] == c) return true;
  }
  return false;
}

static bool is_break(int32_t c) { return c == '\n' || c == '\r'; }

static bool is_space(int32_t c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || is_break(c); }

static bool ends_word(TSLexer *lexer) {
  int32_t c = lexer->lookahead;
  return lexer->eof(lexer) || is_space(c) || c == '#' || is_separator(c);
}

struct Word {
  bool is_integer;
  bool is_number;
  int64_t value;
};

// Reads a word; the lexer stands behind it then.
static struct Word word(TSLexer *lexer) {
  struct Word out = {true, true, 0};
  bool negative = false, digits = false, dot = false, exponent = false, after_e = false;
  bool first = true;
  while (!ends_word(lexer)) {
    int32_t c = lexer->lookahead;
    if ((c == '+' || c == '-') && (first || after_e)) {
      negative = first ? c == '-' : negative;
      after_e = false;
    } else if (c >= '0' && c <= '9') {
      digits = true;
      after_e = false;
      if (out.value < (int64_t)1 << 40) out.value = out.value * 10 + (c - '0');
    } else if (c == '.' && !dot && !exponent) {
      dot = true;
      out.is_integer = false;
    } else if ((c == 'e' || c == 'E') && digits && !exponent) {
      exponent = after_e = true;
      out.is_integer = false;
    } else {
      out.is_integer = out.is_number = false;
    }
    first = false;
    lexer->advance(lexer, false);
  }
  out.is_number = out.is_number && digits && !after_e;
  out.is_integer = out.is_integer && digits;
  if (negative) out.value = -out.value;
  return out;
}

// Reads on from behind the first word of a line: whether that line is a whole record, of a known type.
static bool is_record_line(TSLexer *lexer, struct Word first) {
  if (!first.is_integer || first.value <= 0) return false;
  const struct RecordType *type = NULL;
  int16_t index;
  uint64_t words = 0, count = 0;
  bool in_comment = false;
  while (!lexer->eof(lexer) && (in_comment || !is_break(lexer->lookahead))) {
    int32_t c = lexer->lookahead;
    if (c == '#') {
      in_comment = !in_comment;
      lexer->advance(lexer, false);
    } else if (in_comment || is_space(c) || is_separator(c)) {
      lexer->advance(lexer, false);
    } else {
      struct Word next = word(lexer);
      if (words == 0) {
        type = next.is_integer ? find(next.value, &index) : NULL;
        if (type == NULL) return false;
      } else if (words == 1 && type->params[0] == 'k') {
        count = next.value > 0 ? (uint64_t)next.value : 0;
      }
      words++;
    }
  }
  if (type == NULL) return false;
  uint64_t needed = required(type, count) + 1;
  return words == needed || words == needed + strlen(type->optional);
}

// Steps over white space and comments, on this line alone or up to the next word.
static void skip(TSLexer *lexer, bool over_breaks) {
  bool in_comment = false;
  while (!lexer->eof(lexer)) {
    int32_t c = lexer->lookahead;
    if (is_break(c) && !in_comment && !over_breaks) return;
    if (c == '#') in_comment = !in_comment;
    else if (!in_comment && !is_space(c) && !is_separator(c)) return;
    lexer->advance(lexer, false);
  }
}

// Reads on from behind a word on the line of a record that is whole: whether another record begins with it. Where the line
// does not hold all of that, the next one goes on, unless it is a record by itself.
static bool begins_another(TSLexer *lexer, struct Word first) {
  if (!first.is_integer || first.value < 0) return false;
  // A lone 0 is whole.
  if (first.value == 0) return true;
  const struct RecordType *type = NULL;
  int16_t index;
  uint64_t words = 0, count = 0;
  for (;;) {
    skip(lexer, false);
    if (lexer->eof(lexer) || is_break(lexer->lookahead)) break;
    struct Word next = word(lexer);
    if (words == 0) {
      if (next.is_integer && next.value == 0) return true;
      type = next.is_integer ? find(next.value, &index) : NULL;
      if (type == NULL) return false;
    } else if (words == 1 && type->params[0] == 'k') {
      count = next.value > 0 ? (uint64_t)next.value : 0;
    }
    words++;
    if (words > required(type, count)) return true;
  }
  skip(lexer, true);
  if (lexer->eof(lexer)) return false;
  struct Word below = word(lexer);
  return !(below.is_integer && below.value == 0) && !is_record_line(lexer, below);
}

static enum TokenType token_of(char role) {
  switch (role) {
    case 'r': return REFERENCE;
    case 'c': return COLOUR;
    case 'a': return ANGLE;
    case 'f': return FILE_NAME;
    default: return NUMBER;
  }
}

// A record begins: its ID, or a lone 0.
static enum TokenType begin(struct State *state, struct Word first) {
  memset(state, 0, sizeof *state);
  if (first.is_integer && first.value == 0) return VOID;
  if (!first.is_integer || first.value < 0) return WORD;
  state->stage = AT_TYPE;
  return ID;
}

void *tree_sitter_zpg_external_scanner_create(void) {
  return ts_calloc(1, sizeof(struct State));
}

void tree_sitter_zpg_external_scanner_destroy(void *payload) { ts_free(payload); }

unsigned tree_sitter_zpg_external_scanner_serialize(void *payload, char *buffer) {
  memcpy(buffer, payload, sizeof(struct State));
  return sizeof(struct State);
}

void tree_sitter_zpg_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
  memset(payload, 0, sizeof(struct State));
  if (length == sizeof(struct State)) memcpy(payload, buffer, length);
}

bool tree_sitter_zpg_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
  (void)valid;
  struct State *state = payload;
  while (is_space(lexer->lookahead) || is_separator(lexer->lookahead) || lexer->lookahead == 0xFEFF) {
    if (is_break(lexer->lookahead)) state->broken_line = true;
    lexer->advance(lexer, true);
  }
  if (lexer->eof(lexer)) return false;
  if (lexer->lookahead == '#') {
    bool is_one_line = true;
    do {
      lexer->advance(lexer, false);
      // One that nobody closes ends with its line.
      if (is_one_line && (lexer->eof(lexer) || is_break(lexer->lookahead))) {
        lexer->mark_end(lexer);
        is_one_line = false;
      }
    } while (!lexer->eof(lexer) && lexer->lookahead != '#');
    if (!lexer->eof(lexer)) {
      lexer->advance(lexer, false);
      lexer->mark_end(lexer);
    }
    lexer->result_symbol = COMMENT;
    return true;
  }
  bool first_of_line = state->broken_line;
  state->broken_line = false;
  if (lexer->lookahead == '"') {
    do lexer->advance(lexer, false);
    while (!lexer->eof(lexer) && lexer->lookahead != '"' && !is_break(lexer->lookahead));
    if (lexer->lookahead == '"') lexer->advance(lexer, false);
    lexer->mark_end(lexer);
    bool is_file = state->stage == AT_PARAMS;
    if (is_file) state->read++;
    lexer->result_symbol = is_file ? FILE_NAME : WORD;
    return true;
  }
  struct Word here = word(lexer);
  lexer->mark_end(lexer);
  if (state->stage == AT_PARAMS) {
    const struct RecordType *type = &RECORD_TYPES[state->type];
    char what = role(type, state->count, state->read);
    bool is_needed = state->read < required(type, state->count);
    // A profile's points stand a line each, and look like anything.
    bool may_end = first_of_line && type->params[0] != 'k';
    bool goes_on = is_needed ? !(may_end && is_record_line(lexer, here)) : what != 0 && !first_of_line;
    if (goes_on) {
      if (what == 'k' && here.is_integer && here.value > 0) state->count = (uint32_t)here.value;
      state->read++;
      lexer->result_symbol = here.is_number || what == 'f' ? token_of(what) : WORD;
      return true;
    }
    if (here.is_number && !first_of_line && !begins_another(lexer, here)) {
      lexer->result_symbol = SURPLUS;
      return true;
    }
  } else if (state->stage == AT_TYPE && !(first_of_line && is_record_line(lexer, here))) {
    const struct RecordType *type = here.is_integer ? find(here.value, &state->type) : NULL;
    if (type != NULL) {
      state->stage = AT_PARAMS;
      lexer->result_symbol = TYPE;
      return true;
    }
    // Nobody can say how long it is.
    state->stage = AT_REST;
    lexer->result_symbol = WORD;
    return true;
  } else if (state->stage == AT_REST && !first_of_line) {
    lexer->result_symbol = WORD;
    return true;
  }
  lexer->result_symbol = begin(state, here);
  return true;
}
