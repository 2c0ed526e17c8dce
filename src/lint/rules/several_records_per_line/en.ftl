S503 = { $count ->
    [one] a second record on the same line
   *[other] { $count } more records on the same line
}
    .fix = one record a line
