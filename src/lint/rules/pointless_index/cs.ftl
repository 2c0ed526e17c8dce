W318 = tento index lomu nemá žádný vliv: { $object } { $object-id } nepropouští světlo
    .label = všude, kde index platí, je kt 0
    .help = světlo se láme jen tam, kde objekt část světla propouští: dejte mu optickou vlastnost s kt > 0, například `{ $object-id } -201 0 0.1 0.9`
W318-below-one = index lomu je nejméně 1, jako ve vakuu; zde je { $parts }
    .label = méně než 1
    .help = uvádí se index látky samotného objektu; index okolí se započítá zvlášť
