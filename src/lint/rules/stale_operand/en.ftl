W309 = this { $change } of { $id } comes too late for the { $taker } { $taker-id }{ $more ->
    [0] {""}
    [one] , and so does { $more } more change
   *[other] , and so do { $more } more changes
}
    .label = this changes nothing that is used
    .taken = { $id } is taken here
    .note = an operation takes its operands as they are at that point
    .help = move this in front of the { $taker }, or change { $taker-id } in place of { $id }
    .fix = if it is meant for the object right above, write { $number }
W309-property = the { $type } { $id } is changed too late: { $taker-id } has taken it as it was{ $more ->
    [0] {""}
    [one] {" "}({ $more } more change likewise)
   *[other] {" "}({ $more } more changes likewise)
}
    .label = { W309.label }
    .taken = { $id } is taken here
    .note = properties and colours are taken as they are at that point
    .help = move this in front of the record that takes { $id }
    .fix = { W309.fix }
