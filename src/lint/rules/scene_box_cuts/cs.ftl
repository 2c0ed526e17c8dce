W312 = kvádr renderovacího záznamu ořezává scénu: { $type } { $id } z něj přesahuje v bodě ({ $x }; { $y }; { $z })
    .label = co leží mimo tento kvádr, není vidět
    .shape = toto z něj přesahuje
    .note = řez není uzavřený: je vidět dovnitř objektu
    .help = zvětšete kvádr, nebo označte řez za záměrný: `# zpg: allow(W312) #`
W312-outside = nic nebude vidět: celý objekt { $id } leží mimo kvádr renderovacího záznamu, { $axis } má všude { $where ->
        [above] nejméně
       *[below] nejvýše
    } { $reach }
    .label = { $name }, stěna kvádru
    .note = co leží mimo kvádr, není vidět žádným paprskem
W312-part = { $type } { $id } nebude vidět: leží zcela mimo kvádr renderovacího záznamu, { $axis } je všude { $where ->
        [above] nejméně
       *[below] nejvýše
    } { $reach }{ $others ->
        [0] {""}
        [one] ; mimo leží ještě { $others } další část
        [few] ; mimo leží ještě { $others } další části
       *[other] ; mimo leží ještě { $others } dalších částí
    }
    .label = { $name }, stěna kvádru
    .shape = toto se nevykreslí
    .note = { W312-outside.note }
    .help = zvětšete kvádr, nebo odstraňte, co se nevykreslí
