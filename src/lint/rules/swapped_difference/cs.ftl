W340 = rozdíl { $id } je { $one } bez { $two }, ale jeho komentář říká opak
    .label = druhý operand se odečítá od prvního
    .help = první je to, co zůstane
    .fix = napsat { $number }
W340-taken = rozdíl { $id } je { $one } bez { $two }, ale podle komentáře se odečítá { $one }
    .label = { W340.label }
    .help = { W340.help }
    .fix = { W340.fix }
