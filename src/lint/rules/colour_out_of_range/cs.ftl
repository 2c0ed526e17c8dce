W301 = složky barvy mají být mezi 0 a 1; zde je `{ $parts }`
    .label = barva se použije tak, jak je
    .note = povrch se složkou větší než 1 je jasnější než světlo, které na něj dopadá; záporná složka světlo ubírá. Má-li světlo svítit víc, zvyšte jeho intenzitu
    .bytes = vypadá to na čísla od 0 do 255, která jsou jako v jiných programech sRGB; barvy scény jsou lineární
    .linear = zapsat tato čísla sRGB jako lineární
    .hundredths = vydělit číslem 100
    .shares = vydělit číslem 255
    .point-lost = napsat desetinnou tečku
    .fix = napsat nejbližší přípustnou hodnotu
W301-point = složky barvy mají být mezi 0 a 1; v bodě profilu { $point } je `{ $parts }`{ $others ->
    [0] {""}
    [one] {" "}a mimo rozsah je ještě { $others } barva
    [few] {" "}a mimo rozsah jsou ještě { $others } barvy
   *[other] {" "}a mimo rozsah je ještě { $others } barev
}
    .label = { W301.label }
    .note = { W301.note }
    .bytes = { W301.bytes }
    .linear = { W301.linear }
    .hundredths = { W301.hundredths }
    .shares = { W301.shares }
    .point-lost = { W301.point-lost }
    .fix = { W301.fix }
